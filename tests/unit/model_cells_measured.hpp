#pragma once
// Volume and shape of the cells that a shape makes of itself, and what its reader finds wrong.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "model/scene/reader/reader.hpp"
#include "model/scene/shapes/multilinear.hpp"
#include "tests/scene_text.hpp"

namespace femsph::test {

struct Measured {
  double volume = 0;
  double worst = 1e300;  ///< smallest Jacobian over a corner, as a share of the cell's volume
};

/// Expects every cell right-handed.
inline Measured measured(const CellMesh& mesh) {
  Measured m;
  for (const auto& cell : mesh.cells) {
    Patch patch{mesh.dim, {}};
    for (int v = 0; v < patch.corner_count(); ++v) patch.corners[v] = mesh.vertices[cell[v]];
    const double volume = measure(patch);
    EXPECT_GT(volume, 0) << "left-handed";
    m.volume += volume;
    m.worst = std::min(m.worst, smallest_corner_jacobian(patch) / volume);
  }
  return m;
}

/// The first fault of a scene of one body with the lines `body`, and what follows it; empty: none.
inline std::string shape_fault(const std::string& body, bool space) {
  using namespace scene_text;
  try {
    parse_scene(
        model(space ? "none" : "strain") + material("m", "elastic", "1 MPa", "0.3", "1 kg/m^3") +
            "[bodies.b]\nmaterial = \"m\"\n" + (space ? "" : thick("1 m")) + body + scene_text::time("1 s"),
        "shape.toml");
  } catch (const InputError& e) {
    return e.faults().at(0).text;
  }
  return "";
}

}  // namespace femsph::test
