#pragma once
// Bodies for the tests of what balances a uniform stress: the projection of scattered particles, and sides
// that cut a lattice.

#include <memory>
#include <vector>

#include "sph_support.hpp"

namespace femsph::test {

struct ScatteredBody {
  const char* name;
  std::shared_ptr<const Shape> shape;
  double spacing, smoothing = 1, jitter = 0;
  std::vector<const char*> planes{};  ///< of symmetry
};

inline Scene scene_of(const ScatteredBody& b, bool large = false) {
  Scene s = box_scene(b.shape->dim() == 2 ? Plane::strain : Plane::none, {1, 1, 1}, large);
  s.bodies[0].shape = b.shape;
  s.bodies[0].thickness = b.shape->dim() == 2 ? 0.5 : 1;
  for (const char* side : b.planes) s.symmetries.push_back({Place{0, {side}, {}, {}, {}}});
  return s;
}

}  // namespace femsph::test
