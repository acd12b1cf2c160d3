#pragma once
// Theory values of a loaded box. E is Young's modulus in plane stress and in space, and E/(1 - nu^2) in plane
// strain.

#include <functional>
#include <utility>

#include "compare/reference/values/beam.hpp"
#include "compare/reference/values/theory_value.hpp"

namespace femsph::compare {

/// A value of the loaded box, and where it is asked for: x from the held end, y from the middle of the
/// height.
using BoxValue = std::function<double(const LoadedBox&, double x, double y, double time)>;

inline Theory box_theory(LoadedBox (*box_of)(const Scene&), const char* name, const char* unit,
                         const char* formula, Theory::Depends depends, BoxValue value) {
  return {name, unit, formula, depends, [box_of, value](const Scene& scene, const Point& at, double time) {
            const LoadedBox box = box_of(scene);
            return value(box, at[0] - box.origin[0], at[1] - box.origin[1] - box.height / 2, time);
          }};
}

}  // namespace femsph::compare
