#pragma once
// What round shapes share: the axes of their section, the parts that they can be cut to, and the keys of
// both.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/input/keys.hpp"
#include "model/input/need.hpp"
#include "model/numerics/tensor.hpp"

namespace femsph {

/// How much of a round section there is, seen from its centre: all of it, the half where its second axis is
/// positive, or the quarter where both are.
enum class RoundPart { whole, half, quarter };

/// The coordinates (a, b, along) of a round shape: a and b across its axis, `along` the axis, from its
/// centre. The axes a and b follow the axis cyclically: across z they are x and y.
struct RoundFrame {
  const Point& centre;  ///< m
  int axis;             ///< 0, 1, 2: x, y, z; 2 in a plane
  RoundPart part;

  int first() const { return (axis + 1) % 3; }
  int second() const { return (axis + 2) % 3; }
  int quarters() const { return part == RoundPart::whole ? 4 : part == RoundPart::half ? 2 : 1; }
  std::array<double, 3> local(const Point& p) const {
    return {p[first()] - centre[first()], p[second()] - centre[second()], p[axis] - centre[axis]};
  }
  Point global(double a, double b, double along) const {
    Point p = centre;
    p[first()] += a;
    p[second()] += b;
    p[axis] += along;
    return p;
  }
  /// (a, b) lies in the part, up to `tolerance` (m).
  bool in_part(double a, double b, double tolerance) const {
    return (part == RoundPart::whole || b >= -tolerance) && (part != RoundPart::quarter || a >= -tolerance);
  }
  /// The lower corner of the bounding box of a section of this radius (m), at `along`.
  Point lower(double radius, double along) const {
    return global(part == RoundPart::quarter ? 0 : -radius, part == RoundPart::whole ? -radius : 0, along);
  }
  /// The point of the part's symmetry line that lies `distance` (m) beyond the straight sides: the centroid
  /// of a half lies on b, that of a quarter at the same distance along a and b.
  Point beyond(double distance, double along) const {
    return global(part == RoundPart::quarter ? distance : 0, part == RoundPart::whole ? 0 : distance, along);
  }
  /// "", "half " or "quarter ", for messages.
  const char* adjective() const {
    return part == RoundPart::whole ? "" : part == RoundPart::half ? "half " : "quarter ";
  }
};

// The keys "centre", "radius", "part" and "axis", and their reading.
Key centre_key(const std::string& about);
Key radius_key();
Key part_key();
Key axis_key(const std::string& about, bool required);
std::optional<RoundPart> read_part(Fields& body);
std::optional<int> read_axis(Fields& body, Need need);

}  // namespace femsph
