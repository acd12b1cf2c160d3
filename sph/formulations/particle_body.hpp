#pragma once
// What every SPH discretization has in common: where its particles are, what they weigh, and how places and
// probes find them.

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

  /// Particles of a place. Where they lie on it a force is shared in proportion to their volumes (of a fitted
  /// body to the area of its facets); a side that cuts a lattice has the layer of particles whose cells it
  /// cuts, each with its area there.
  std::vector<Weight> points_of(const Place& place) const override;
  std::vector<PointArea> outward_areas(const Place& place) const override;
  /// The particle at p itself; between particles, a moving least-squares fit that reproduces linear fields.
  std::vector<Weight> interpolation(const Point& p) const override;
  std::vector<Weight> material_interpolation(const Point& p) const override { return interpolation(p); }
  std::size_t material_points() const override { return particles_.size(); }
  Point material_position(std::size_t point) const override { return particles_.position[point]; }
  double material_volume(std::size_t point) const override {
    return particles_.own_volume(point) * thickness_;
  }
  /// Each particle at its own place; see TotalLagrangian for where a corrected gradient belongs.
  MaterialUnits material_units() const override;
  Topology topology() const override;
  /// The sides of the lattice's cells between particles that belong to one cell: particles sit on the
  /// surface, and so do they; of a fitted body those of its own cells.
  std::vector<Facet> boundary() const override;

 protected:
  /// The flat vector u with the mirrored particles filled in: u itself in a body without symmetry planes.
  /// Valid until the next call.
  const double* with_mirrored(const double* u) const {
    return particles_.mirrored.empty() ? u : fill_mirrored(u);
  }
  Point place_now(std::size_t particle, const double* u) const;  ///< m, in the deformed body
  /// What to say if a particle's det F is not positive.
  std::optional<Trouble> inside_out(const AlignedVector<double>& det, const double* u) const;
  /// What a uniform stress must be in balance with: the areas of boundary() at their corners. Empty where the
  /// weights are not made so: on lattices, which are right by themselves, where sides cut the lattice, in
  /// classic SPH, and if the options say so.
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
  bool steps_ = false;  ///< a lattice in a body that is no box: its sides cut cells
  std::vector<double> mass_;
  mutable AlignedVector<double> mirrored_;
  std::string bars_text_;
};

}  // namespace femsph::sph
