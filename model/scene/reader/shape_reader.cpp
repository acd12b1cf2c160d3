#include "model/scene/reader/shape_reader.hpp"

#include <fmt/format.h>

#include <cctype>
#include <stdexcept>

#include "model/scene/shapes/structured_shapes.hpp"

namespace femsph {
namespace {

using ShapePointer = std::shared_ptr<const Shape>;

ShapePointer read_box(Fields& body, int dim, const std::filesystem::path&) {
  const auto size = body.vector("size", Need::required, dimension::length, dim, Sign::positive);
  const auto origin = body.vector("origin", Need::optional, dimension::length, dim);
  return size && dim ? std::make_shared<Box>(dim, origin.value_or(Point{}), *size) : nullptr;
}

template <int ball_dim>
ShapePointer read_ball(Fields& body, int dim, const std::filesystem::path&) {
  const auto centre = body.vector("centre", Need::required, dimension::length, dim);
  const auto radius = body.quantity("radius", Need::required, dimension::length, Sign::positive);
  if (dim && dim != ball_dim)
    return body.fault("shape", ball_dim == 2 ? "a disc in a three-dimensional scene; expected \"sphere\""
                                             : "a sphere in a plane scene; expected \"disc\""),
           nullptr;
  return centre && radius && dim ? std::make_shared<Ball>(dim, *centre, *radius) : nullptr;
}

std::optional<double> read_length_unit(Fields& body) {
  const std::string expected = "a unit of length, such as \"mm\"";
  const auto unit = body.text("unit", Need::required, expected);
  if (!unit) return {};
  try {
    const bool has_number = !unit->empty() &&
                            std::isdigit((unsigned char)unit->front());  // "25.4 mm" is a unit as well
    if (const double length = to_si((has_number ? "" : "1 ") + *unit, dimension::length); length > 0)
      return length;
  } catch (const std::invalid_argument&) {  // said below, without the "1" that the user did not write
  }
  body.fault("unit", fmt::format("\"unit\" is {}; expected {}", in_quotes(*unit), expected));
  return {};
}

ShapePointer read_mesh(Fields& body, int dim, const std::filesystem::path& folder) {
  const auto file = body.text("file", Need::required, "the path of a .msh file");
  const auto unit = read_length_unit(body);
  const MeshWish wish{body.count("pieces", Need::optional, 1, 1'000'000).value_or(1),
                      body.flag("open_seams", Need::optional).value_or(false)};
  if (!file || !unit || !dim) return nullptr;
  try {
    return std::make_shared<MeshShape>(
        read_gmsh((folder / *file).lexically_normal().string(), dim, *unit, wish), *file);
  } catch (const std::runtime_error& e) {
    body.fault("file", e.what());
    return nullptr;
  }
}

/// Keys of a circular section; `hollow` ones have two radii, in space they have an axis and a length.
template <int round_dim, bool hollow>
ShapePointer read_round(Fields& body, int dim, const std::filesystem::path&) {
  using Part = Round::Part;
  Round::Size size;
  const auto centre = body.vector("centre", Need::required, dimension::length, dim);
  const auto outer = body.quantity(
      hollow ? "outer" : "radius", Need::required, dimension::length, Sign::positive);
  const auto inner = hollow ? body.quantity("inner", Need::required, dimension::length, Sign::positive)
                            : std::optional<double>(0.0);
  const auto part = body.choice<Part>(
      "part", Need::optional, {{"whole", Part::whole}, {"half", Part::half}, {"quarter", Part::quarter}});
  std::optional<double> length(0.0);
  if (round_dim == 3) {
    const auto axis = body.choice<int>("axis", Need::required, {{"x", 0}, {"y", 1}, {"z", 2}});
    length = body.quantity("length", Need::required, dimension::length, Sign::positive);
    if (!axis) return nullptr;
    size.axis = *axis;
  }
  if (dim && dim != round_dim)
    return body.fault("shape", round_dim == 2
                                   ? "a ring in a three-dimensional scene; expected \"tube\""
                                   : "a cylinder or tube in a plane scene; expected \"disc\" or \"ring\""),
           nullptr;
  if (hollow && inner && outer && *inner >= *outer)
    return body.fault(
               "inner",
               fmt::format("\"inner\" is {:g} mm, not below \"outer\", {:g} mm; expected the smaller radius",
                           *inner * 1e3, *outer * 1e3)),
           nullptr;
  if (!centre || !outer || !inner || !length || !dim) return nullptr;
  size.centre = *centre, size.outer = *outer, size.inner = *inner, size.length = *length,
  size.part = part.value_or(Part::whole);
  return std::make_shared<Round>(dim, size);
}

ShapePointer read_own_ball(Fields& body, int dim, const std::filesystem::path&) {
  using Part = OwnBall::Part;
  const auto centre = body.vector("centre", Need::required, dimension::length, dim);
  const auto radius = body.quantity("radius", Need::required, dimension::length, Sign::positive);
  const auto axis = body.choice<int>("axis", Need::optional, {{"x", 0}, {"y", 1}, {"z", 2}});
  const auto part = body.choice<Part>(
      "part", Need::optional, {{"whole", Part::whole}, {"half", Part::half}, {"quarter", Part::quarter}});
  const auto finer = body.number("finer", Need::optional);
  if (dim == 2) return body.fault("shape", "a ball in a plane scene; expected \"disc\""), nullptr;
  if (finer && !(*finer >= 1 && *finer <= 20))
    return body.fault(
               "finer",
               fmt::format(
                   "\"finer\" is {:g}; expected how many times finer the cells are at the pole, from 1 to 20",
                   *finer)),
           nullptr;
  if (!centre || !radius || !dim) return nullptr;
  return std::make_shared<OwnBall>(
      OwnBall::Size{*centre, *radius, axis.value_or(2), part.value_or(Part::whole), finer.value_or(1.0)});
}

ShapePointer read_quadrilateral(Fields& body, int dim, const std::filesystem::path&) {
  std::array<Point, 4> corners;
  bool all = true;
  const char* keys[] = {"corner1", "corner2", "corner3", "corner4"};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto corner = body.vector(keys[k], Need::required, dimension::length, dim);
    corners[k] = corner.value_or(Point{});
    all = all && corner;
  }
  if (dim == 3)
    return body.fault(
               "shape", "a quadrilateral in a three-dimensional scene; expected a plane one, or a \"mesh\""),
           nullptr;
  if (!all || !dim) return nullptr;
  for (std::size_t k = 0; k < 4; ++k) {
    const Point &a = corners[k], &b = corners[(k + 1) % 4], &c = corners[(k + 2) % 4];
    if (!((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) > 0))
      return body.fault(keys[(k + 1) % 4], fmt::format("the corners turn the wrong way at \"{}\"; expected a "
                                                       "convex quadrilateral, counterclockwise from the "
                                                       "lower left",
                                                       keys[(k + 1) % 4])),
             nullptr;
  }
  return std::make_shared<Quadrilateral>(corners);
}

using Reader = ShapePointer (*)(Fields&, int, const std::filesystem::path&);

/// Every shape a scene can name.
const std::vector<std::pair<std::string, Reader>> shapes = {
    {"box", read_box},
    {"disc", read_ball<2>},
    {"sphere", read_ball<3>},
    {"mesh", read_mesh},
    {"ring", read_round<2, true>},
    {"cylinder", read_round<3, false>},
    {"tube", read_round<3, true>},
    {"quadrilateral", read_quadrilateral},
    {"ball", read_own_ball}};

}  // namespace

ShapePointer read_shape(Fields& body, int dim, const std::filesystem::path& folder) {
  const auto read = body.choice<Reader>("shape", Need::required, shapes);
  if (read) return (*read)(body, dim, folder);
  body.accept_rest();
  return nullptr;
}

}  // namespace femsph
