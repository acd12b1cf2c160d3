#pragma once
// The finite element discretization of a body for the explicit time loop.

#include <optional>
#include <span>
#include <vector>

#include "fem/elements/cell_loop.hpp"
#include "fem/mesh/batches.hpp"
#include "fem/mesh/locator.hpp"
#include "fem/mesh/mesh.hpp"
#include "fem/options.hpp"
#include "fem/truss_bars.hpp"

namespace femsph::fem {

class ExplicitFem : public Discretization {
 public:
  ExplicitFem(const Scene& scene, std::size_t body, const Options& options);

  std::string describe() const override;
  std::vector<std::string> warnings() const override;
  const Layout& layout() const override { return layout_; }
  std::span<const double> mass() const override { return mass_; }
  Point position(std::size_t point) const override { return mesh_.node(point); }
  std::size_t units() const override { return mesh_.cell_count(); }
  std::string unit_name() const override { return "element"; }
  double spacing() const override { return spacing_; }
  double wave_speed() const override { return wave_speed_; }
  std::size_t bytes() const override;

  void internal_force(const double* u, const double* v, double dt, double* f, double* viscous) override;
  void stiffness(const double* x, double* y) const override;
  Energies energies(const double* u) const override;
  std::optional<Trouble> trouble(const double* u) const override;
  std::optional<Stiffening> stiffening(const double* u) const override;
  void state(Archive& archive) override { loop_->state(archive), bars_.state(archive); }
  std::vector<BarPiece> bars(const double* u) const override { return bars_.pieces(u); }

  std::vector<Weight> points_of(const Place& place) const override;
  std::vector<Weight> interpolation(const Point& p) const override;

  std::size_t material_points() const override {
    return mesh_.cell_count() * static_cast<std::size_t>(loop_->points_per_cell());
  }
  Point material_position(std::size_t point) const override;
  double material_volume(std::size_t point) const override;
  /// With 2^dim points a cell: each cell that contains p extrapolates its values to p, multilinearly through
  /// its points, and the mean over these cells is taken. With one point a cell: a linear least-squares fit to
  /// the cells around p.
  std::vector<Weight> material_interpolation(const Point& p) const override;
  MaterialUnits material_units() const override;
  void material_state(const double* u, std::span<const std::size_t> points,
                      MaterialState& out) const override;
  Topology topology() const override;

 protected:
  std::shared_ptr<const Shape> shape_;
  const ElementEntry& element_;
  std::optional<double> hourglass_;  ///< of Options
  double thickness_;
  Plane plane_;
  Mesh mesh_;
  Batches batches_;

 private:
  void clear(double* f) const;

  Layout layout_;
  std::vector<double> mass_;
  double spacing_, wave_speed_;
  Locator locator_;
  std::size_t cell_of(std::size_t lane) const;
  Point centre_now(std::size_t cell, const double* u) const;  ///< m, in the deformed body
  Law law_;
  bool yields_ = false;
  std::unique_ptr<CellLoop> loop_;
  TrussBars bars_;
  std::string bars_text_;
};

}  // namespace femsph::fem
