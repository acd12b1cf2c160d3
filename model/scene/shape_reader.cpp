#include "model/scene/shape_reader.hpp"

#include <fmt/format.h>

#include <stdexcept>

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
    return body.fault("shape", ball_dim == 2 ? "a disc in a three-dimensional scene; expected \"sphere\"" : "a sphere in a plane scene; expected \"disc\""), nullptr;
  return centre && radius && dim ? std::make_shared<Ball>(dim, *centre, *radius) : nullptr;
}

std::optional<double> read_length_unit(Fields& body) {
  const std::string expected = "a unit of length, such as \"mm\"";
  const auto unit = body.text("unit", Need::required, expected);
  if (!unit) return {};
  try {
    if (const double length = to_si("1 " + *unit, dimension::length); length > 0) return length;
  } catch (const std::invalid_argument&) {  // said below, without the "1" that the user did not write
  }
  body.fault("unit", fmt::format("\"unit\" is {}; expected {}", in_quotes(*unit), expected));
  return {};
}

ShapePointer read_mesh(Fields& body, int dim, const std::filesystem::path& folder) {
  const auto file = body.text("file", Need::required, "the path of a .msh file");
  const auto unit = read_length_unit(body);
  if (!file || !unit || !dim) return nullptr;
  try {
    return std::make_shared<MeshShape>(read_gmsh((folder / *file).lexically_normal().string(), dim, *unit), *file);
  } catch (const std::runtime_error& e) {
    body.fault("file", e.what());
    return nullptr;
  }
}

using Reader = ShapePointer (*)(Fields&, int, const std::filesystem::path&);

/// Every shape a scene can name.
const std::vector<std::pair<std::string, Reader>> shapes = {{"box", read_box}, {"disc", read_ball<2>}, {"sphere", read_ball<3>}, {"mesh", read_mesh}};

}  // namespace

ShapePointer read_shape(Fields& body, int dim, const std::filesystem::path& folder) {
  const auto read = body.choice<Reader>("shape", Need::required, shapes);
  if (read) return (*read)(body, dim, folder);
  body.accept_rest();
  return nullptr;
}

}  // namespace femsph
