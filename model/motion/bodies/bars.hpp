#pragma once
// Which points of a discretization carry a bar. A bar between two rows of points is shared by them in inverse
// proportion to their distances, so that its force acts at the right height on any mesh.

#include <span>
#include <string>
#include <vector>

#include "model/material/bar_law.hpp"
#include "model/numerics/archive.hpp"
#include "model/scene/scene.hpp"

namespace femsph {

/// A row of points along a bar, and the share of the bar that it carries.
struct BarRow {
  std::size_t bar;  ///< index into Scene::bars
  int axis;
  double area;  ///< m^2
  BarLaw law;
  Point at{};                       ///< where the row is across the axis, m
  std::vector<std::size_t> points;  ///< along the axis
  std::vector<double> length;       ///< of the bar within each point's cell (to halfway to its neighbours), m
  std::vector<double> segment;      ///< of the bar between points k and k + 1, m
  std::vector<double> gap;          ///< between points k and k + 1, m
};

/// The rows that carry the bars of one body. `tolerance`: how far a point of a row may lie beside it, m.
/// Throws std::runtime_error with one sentence if no rows lie along a bar.
std::vector<BarRow> bar_rows(const Scene& scene, std::size_t body, std::span<const Point> points,
                             double tolerance);

/// What the bars' laws remember: the member `state` of every truss or piece.
template <class Piece>
void bar_states(Archive& archive, std::vector<Piece>& pieces) {
  if (pieces.empty()) return;
  archive.each("bar_stress", pieces, [](Piece& p) -> double& { return p.state.stress; });
  archive.each("bar_plastic_strain", pieces, [](Piece& p) -> double& { return p.state.plastic_strain; });
  archive.each("bar_equivalent", pieces, [](Piece& p) -> double& { return p.state.equivalent; });
  archive.each("bar_dissipated", pieces, [](Piece& p) -> double& { return p.state.dissipated; });
}

/// ", bar bottom at y = 37.5 mm (64 %) and 50 mm (36 %)" for each bar: for Discretization::describe.
std::string describe(const std::vector<BarRow>& rows, const Scene& scene);

}  // namespace femsph
