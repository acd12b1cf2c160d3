#pragma once
// The rows of points that carry a reinforcing bar. A bar between two rows is distributed to both by the lever
// rule, so that its force acts at the right height on any grid.

#include <span>
#include <string>
#include <vector>

#include "model/material/bar_law.hpp"
#include "model/numerics/archive.hpp"
#include "model/scene/scene.hpp"

namespace femsph {

/// A row of points along a bar, and the part of the bar that it carries.
struct BarRow {
  std::size_t bar;  ///< index into Scene::bars
  int axis;
  double area;  ///< the part of the bar's area, m^2
  BarLaw law;
  Point at{};                       ///< the coordinates of the row across the axis, m
  std::vector<std::size_t> points;  ///< in order along the axis
  std::vector<double> length;   ///< m: length of bar that belongs to each point (halfway to its neighbours)
  std::vector<double> segment;  ///< m: length of bar between points k and k + 1
  std::vector<double> gap;      ///< m: distance of points k and k + 1
};

/// The rows that carry the bars of one body. `points`: undeformed positions, m. `tolerance` (m): how far a
/// point may lie beside its row. Throws Refusal if there are no rows along a bar.
std::vector<BarRow> bar_rows(const Scene& scene, std::size_t body, std::span<const Point> points,
                             double tolerance);

/// Saves or restores the history of the bars: the member `state` of every piece.
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
