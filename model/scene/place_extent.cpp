#include "model/scene/place_extent.hpp"

#include <algorithm>
#include <cmath>

#include "model/scene/shapes/structured.hpp"

namespace femsph {
namespace {

/// Whether a facet of some cell has at least `corners` vertices on the place: 2 for an edge, 4 for a face in
/// space.
bool some_facet_on(const Shape& shape, const CellMesh& mesh, const Place& place, int corners) {
  const double tolerance = point_tolerance(shape);
  std::vector<char> on(mesh.vertices.size());
  for (std::size_t v = 0; v < on.size(); ++v)
    on[v] = std::all_of(place.sides.begin(), place.sides.end(), [&](const std::string& side) {
      return shape.on_side(side, mesh.vertices[v], tolerance);
    });
  const int per_cell = mesh.dim == 2 ? 4 : 8;
  for (const auto& cell : mesh.cells)
    for (int axis = 0; axis < mesh.dim; ++axis)
      for (int end = 0; end < 2; ++end) {
        int found = 0;  // on the facet of the cell normal to that axis
        for (int c = 0; c < per_cell; ++c) found += ((c >> axis) & 1) == end && on[cell[c]];
        if (found >= corners) return true;
      }
  return false;
}

}  // namespace

double point_tolerance(const Shape& shape) {
  const Point a = shape.lower(), b = shape.upper();
  return 1e-6 * std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

Region part_of(const Shape& box, const Place& place) {
  Region part{box.lower(), box.upper()};
  for (const std::string& side : place.sides) {
    const int axis = side[0] - 'x';
    (side[1] == '-' ? part.upper : part.lower)[axis] = (side[1] == '-' ? part.lower : part.upper)[axis];
  }
  if (place.within)
    for (int c = 0; c < 3; ++c)
      part.lower[c] = std::max(part.lower[c], place.within->lower[c]),
      part.upper[c] = std::min(part.upper[c], place.within->upper[c]);
  return part;
}

int codimension(const Scene& scene, const Place& place) {
  const Shape& shape = *scene.bodies[place.body].shape;
  const int dim = scene.dim();
  if (place.point) return dim;
  if (place.sides.empty()) return 0;
  if (shape.is_box()) {
    const Region part = part_of(shape, place);
    int lacking = 0;
    for (int c = 0; c < dim; ++c) lacking += part.upper[c] - part.lower[c] <= point_tolerance(shape);
    return lacking;
  }
  if (shape.touches_sides_in_points()) return dim;
  CellMesh cut;
  const CellMesh* mesh = shape.cells();
  if (const StructuredShape* own = shape.structured(); own && !mesh) mesh = &(cut = own->mesh({4, 4, 4}));
  if (!mesh) return int(place.sides.size());
  if (some_facet_on(shape, *mesh, place, dim == 2 ? 2 : 4)) return 1;
  return dim == 3 && some_facet_on(shape, *mesh, place, 2) ? 2 : dim;
}

bool at_place(const Scene& scene, const Place& place, const Point& p, double reach) {
  const Shape& shape = *scene.bodies[place.body].shape;
  const double near = std::max(reach, point_tolerance(shape));
  Region part;
  if (place.point) {
    part = {*place.point, *place.point};
  } else if (shape.is_box()) {
    part = part_of(shape, place);
  } else {
    return std::all_of(place.sides.begin(), place.sides.end(),
                       [&](const std::string& side) { return shape.on_side(side, p, near); }) &&
           (!place.within || place.within->contains(p, near));
  }
  double distance = 0;
  for (int c = 0; c < scene.dim(); ++c) {
    const double off = std::max({0.0, part.lower[c] - p[c], p[c] - part.upper[c]});
    distance += off * off;
  }
  return std::sqrt(distance) <= near;
}

}  // namespace femsph
