#include "model/motion/bodies/motion.hpp"

#include <fmt/format.h>

namespace femsph {

std::vector<Weight> Motion::points_of(const MovingBody& body, const Place& place, const char* what) const {
  std::vector<Weight> points = body.discretization->points_of(place);
  if (points.empty())
    throw MotionError(fmt::format(
        "{}:{}:{}: this {} finds no point of body \"{}\" ({}); use a finer spacing or another place",
        scene.file, place.source.line, place.source.column, what, body.name,
        body.discretization->describe()));
  return points;
}

std::pair<std::size_t, int> component_of(const Layout& at, std::size_t slot) {
  const std::size_t k = slot - at.offset;
  if (at.component_stride == 1)
    return {k / at.point_stride, int(k % at.point_stride)};  // the components of a point side by side
  return {(k % at.component_stride) / at.point_stride,
          int(k / at.component_stride)};  // one row for each component
}

}  // namespace femsph
