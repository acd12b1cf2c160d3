// The shape of a mesh: which points lie inside, and which on its sides and physical groups.

#include "model/scene/shapes/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "model/input/toml_fields.hpp"
#include "model/scene/shapes/multilinear.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph {
namespace {

template <std::size_t n>
Patch patch_of(const CellMesh& mesh, const std::array<int, n>& vertices, int k) {
  Patch patch{k, {}};
  for (int v = 0; v < patch.corner_count(); ++v) patch.corners[v] = mesh.vertices[vertices[v]];
  return patch;
}

Patch cell_patch(const CellMesh& mesh, int cell) { return patch_of(mesh, mesh.cells[cell], mesh.dim); }
Patch facet_patch(const CellMesh& mesh, int facet) {
  return patch_of(mesh, mesh.facets[facet].vertices, mesh.dim - 1);
}

/// A side of a cell, how many cells have it, and which facets of the file are this side.
struct CellSide {
  std::array<int, 4> vertices;  ///< of the first cell, lexicographic
  double outward;               ///< 1 if the areas of add_pieces() point out of that cell, else -1
  int cells;
  std::vector<int> named;
};

template <std::size_t n>
std::array<int, 4> sorted(const std::array<int, n>& vertices, int count) {
  std::array<int, 4> s{-1, -1, -1, -1};
  std::copy_n(vertices.begin(), count, s.begin());
  std::sort(s.begin(), s.end());
  return s;
}

std::vector<CellSide> cell_sides(const CellMesh& mesh) {
  std::map<std::array<int, 4>, CellSide> sides;
  const int count = 2 * (mesh.dim - 1);
  for (const auto& cell : mesh.cells)
    for (int a = 0; a < mesh.dim; ++a)
      for (int end = 0; end < 2; ++end) {
        std::array<int, 4> vertices{};
        for (int v = 0, k = 0; v < 1 << mesh.dim; ++v)
          if ((v >> a & 1) == end) vertices[k++] = cell[v];
        // In a cell with positive Jacobian the cross product of the tangents (y, z) points out of side x+,
        // that of (z, x) = -(x, z) out of y+, and so on; in the plane (0, 0, 1) replaces z.
        const double sign = (end ? 1 : -1) * (a == 1 ? -1 : 1);
        ++sides.try_emplace(sorted(vertices, count), CellSide{vertices, sign, 0, {}}).first->second.cells;
      }
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
    if (const auto side = sides.find(sorted(mesh.facets[f].vertices, count)); side != sides.end())
      side->second.named.push_back(int(f));
  std::vector<CellSide> out;
  for (auto& [key, side] : sides) out.push_back(std::move(side));
  return out;
}

}  // namespace

MeshShape::MeshShape(CellMesh mesh, std::string file) : mesh_(std::move(mesh)), file_(std::move(file)) {
  lower_ = upper_ = mesh_.vertices.at(0);
  for (const Point& p : mesh_.vertices)
    for (int c = 0; c < 3; ++c) {
      lower_[c] = std::min(lower_[c], p[c]);
      upper_[c] = std::max(upper_[c], p[c]);
    }
  std::vector<BoxGrid::Box> boxes;
  for (std::size_t i = 0; i < mesh_.cells.size(); ++i)
    boxes.push_back(bounding_box(cell_patch(mesh_, int(i))));
  cell_grid_ = BoxGrid(boxes);
  boxes.clear();
  for (std::size_t i = 0; i < mesh_.facets.size(); ++i)
    boxes.push_back(bounding_box(facet_patch(mesh_, int(i))));
  facet_grid_ = BoxGrid(boxes);
}

bool MeshShape::contains(const Point& p, double tolerance) const {
  for (int c = 0; c < mesh_.dim; ++c)
    if (!(p[c] >= lower_[c] - tolerance && p[c] <= upper_[c] + tolerance)) return false;
  return cell_grid_.any_near(
      p, tolerance, [&](int cell) { return is_near(cell_patch(mesh_, cell), p, tolerance); });
}

std::vector<std::string> MeshShape::sides() const {
  std::vector<std::string> all = Shape::sides();
  all.insert(all.end(), mesh_.groups.begin(), mesh_.groups.end());
  return all;
}

bool MeshShape::on_side(const std::string& side, const Point& p, double tolerance) const {
  const auto found = std::find(mesh_.groups.begin(), mesh_.groups.end(), side);
  if (found == mesh_.groups.end()) return Shape::on_side(side, p, tolerance);
  const int group = int(found - mesh_.groups.begin());
  return facet_grid_.any_near(p, tolerance, [&](int facet) {
    return mesh_.facets[facet].group == group && is_near(facet_patch(mesh_, facet), p, tolerance);
  });
}

double MeshShape::measure() const {
  double sum = 0;
  for (std::size_t i = 0; i < mesh_.cells.size(); ++i) sum += femsph::measure(cell_patch(mesh_, int(i)));
  return sum;
}

Point MeshShape::centroid() const {
  Point sum{};
  for (std::size_t i = 0; i < mesh_.cells.size(); ++i) {
    const Point moment = first_moment(cell_patch(mesh_, int(i)));
    for (int c = 0; c < 3; ++c) sum[c] += moment[c];
  }
  const double all = measure();
  for (double& x : sum) x /= all;
  return sum;
}

/// The facets of a group; for a side of the bounding box the free sides of cells that lie on it.
std::vector<SidePiece> MeshShape::side_pieces(const std::string& side, double size) const {
  const auto found = std::find(mesh_.groups.begin(), mesh_.groups.end(), side);
  const int group = found == mesh_.groups.end() ? -1 : int(found - mesh_.groups.begin());
  std::vector<SidePiece> pieces;
  for (const CellSide& s : cell_sides(mesh_)) {
    bool on = group < 0 && s.cells == 1;
    if (group < 0)
      for (int v = 0; v < 2 * (dim() - 1) && on; ++v)
        on = Shape::on_side(side, mesh_.vertices[s.vertices[v]], 1e-9 * (upper_[0] - lower_[0]));
    else
      on = std::any_of(s.named.begin(), s.named.end(), [&](int f) { return mesh_.facets[f].group == group; });
    if (!on) continue;
    const std::size_t before = pieces.size();
    add_pieces(patch_of(mesh_, s.vertices, dim() - 1), size, s.outward, pieces);
    for (std::size_t k = before; s.cells > 1 && k < pieces.size(); ++k) pieces[k].area = {};
  }
  return pieces;
}

std::string MeshShape::describe() const {
  return fmt::format(
      "mesh {} of {} {}", file_, mesh_.cells.size(), mesh_.dim == 2 ? "quadrilaterals" : "hexahedra");
}

namespace {

std::optional<double> read_length_unit(Fields& body) {
  const std::string expected = "a unit of length, such as \"mm\"";
  const auto unit = body.text("unit", Need::required, expected);
  if (!unit) return {};
  try {
    const bool has_number =
        !unit->empty() && std::isdigit((unsigned char)unit->front());  // "25.4 mm" is accepted as a unit too
    if (const double length = to_si((has_number ? "" : "1 ") + *unit, dimension::length); length > 0)
      return length;
  } catch (const std::invalid_argument&) {  // reported below, without the "1" that the user has not written
  }
  body.fault("unit", fmt::format("\"unit\" is {}; expected {}", in_quotes(*unit), expected));
  return {};
}

ShapePointer read_mesh(Fields& body, int dim, const std::filesystem::path& folder) {
  const auto file = body.text("file", Need::required, "the path of a .msh file");
  const auto unit = read_length_unit(body);
  const MeshOptions options{body.count("pieces", Need::optional, 1, 1'000'000).value_or(1),
                            body.flag("open_seams", Need::optional).value_or(false)};
  if (!file || !unit || !dim) return nullptr;
  try {
    return std::make_shared<MeshShape>(
        read_gmsh((folder / *file).lexically_normal().string(), dim, *unit, options), *file);
  } catch (const std::runtime_error& e) {
    body.fault("file", e.what());
    return nullptr;
  }
}

}  // namespace

ShapeEntry mesh_entry() {
  return {{"mesh",
           "a mesh of quadrilaterals or hexahedra from Gmsh, for both solvers",
           {{"file", key_holds::text, "The path of the .msh file, relative to the folder of the scene file.",
             true},
            {"unit", "a text: a unit of length, such as \"mm\"", "The unit of the coordinates in the file.",
             true},
            {"pieces", key_holds::count,
             "How many separate pieces the mesh has; a piece is a set of cells that are joined by common "
             "sides. 1 unless given."},
            {"open_seams", key_holds::flag,
             "true: cell sides that coincide without sharing vertices are meant, as the faces of a crack. "
             "false unless given."}}},
          read_mesh};
}

}  // namespace femsph
