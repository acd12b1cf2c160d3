#pragma once
// What every SPH discretization has in common: positions and masses of particles, and the particles of places
// and probes.

#include <string>

#include "model/motion/bodies/discretization.hpp"
#include "model/numerics/array.hpp"
#include "sph/formulations/smeared_bars.hpp"
#include "sph/operators/kernel.hpp"
#include "sph/particles/particles.hpp"

namespace femsph::sph {

class ParticleBody : public Discretization {
 public:
  ParticleBody(const Scene& scene, std::size_t body, const Options& options, Particles particles,
               const Kernel& kernel);

  std::string describe() const override;
  const Layout& layout() const override { return layout_; }
  std::span<const double> mass() const override { return mass_; }
  Point position(std::size_t point) const override { return particles_.position[point]; }
  std::size_t units() const override { return particles_.size(); }
  std::string unit_name() const override { return "particle"; }
  double spacing() const override { return particles_.spacing; }
  double wave_speed() const override { return wave_speed_; }
  std::size_t bytes() const override;

  std::vector<std::string> warnings() const override;

  /// The particles of a place. On particles that lie on it a force is shared in proportion to their volumes
  /// (of a fitted body to the areas of its facets). A side that cuts the lattice has the layer of particles
  /// whose cells it cuts, each weighted by the area of the side in its cell.
  std::vector<Weight> points_of(const Place& place) const override;
  std::vector<PointArea> outward_areas(const Place& place) const override;
  /// The particle at p alone; between particles a moving least-squares fit, exact for linear fields.
  std::vector<Weight> interpolation(const Point& p) const override;
  std::vector<Weight> material_interpolation(const Point& p) const override { return interpolation(p); }
  std::size_t material_points() const override { return particles_.size(); }
  Point material_position(std::size_t point) const override { return particles_.position[point]; }
  double material_volume(std::size_t point) const override {
    return particles_.own_volume(point) * thickness_;
  }
  /// Each particle at its position; StiffnessBody has the places where a corrected gradient is most accurate.
  MaterialUnits material_units() const override;
  Topology topology() const override;
  /// The free sides of the cells whose corners are particles: of the lattice, or of a fitted body.
  std::vector<Facet> boundary() const override;

 protected:
  /// The flat vector u with the values of mirrored particles filled in; u itself in a body without symmetry
  /// planes. Valid until the next call.
  const double* with_mirrored(const double* u) const {
    return particles_.mirrored.empty() ? u : fill_mirrored(u);
  }
  Point place_now(std::size_t particle, const double* u) const;  ///< m, in the deformed body
  /// Trouble if det F of a particle is not positive.
  std::optional<Trouble> inside_out(const AlignedVector<double>& det, const double* u) const;
  /// The area vectors with which a uniform stress must be in balance (projection.hpp): those of boundary(),
  /// shared among its corners. Empty where weights are not projected: on lattices, in uncorrected SPH, and
  /// without Options::projection.
  std::vector<Point> uniform_stress_areas() const;
  std::vector<std::string> warnings_;
  Options options_;
  const Formulation& formulation_;
  Particles particles_;
  std::shared_ptr<const Shape> shape_;
  double thickness_, density_, wave_speed_;
  Layout layout_;
  SmearedBars bars_;

 private:
  const double* fill_mirrored(const double* u) const;
  double filled_share(std::size_t i) const;
  double share_within(const Region& region, std::size_t i) const;
  std::vector<Weight> layer_at(const Place& place) const;
  std::size_t owner_of(const Point& x) const;
  void share_out(const SidePiece& piece, std::vector<PointArea>& out) const;
  void weigh_by_area(std::vector<Weight>& points) const;
  std::vector<PointArea> facet_areas(const std::vector<Weight>& points) const;
  bool in_body(std::size_t i) const;
  bool steps_ = false;  ///< sides of the body cut cells of the lattice
  std::vector<double> mass_;
  mutable AlignedVector<double> mirrored_;
  std::string bars_text_;
};

}  // namespace femsph::sph
