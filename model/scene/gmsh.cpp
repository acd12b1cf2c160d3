// Reads quadrilateral and hexahedral meshes through the library of Gmsh, so that every version of the .msh format works. The library trusts its
// input: damaged files make it read beyond its arrays or ask for all memory. So it works in a process of its own, which hands the mesh back.
// Numbering of vertices and elements: Gmsh reference manual, "Node ordering" and "MSH file format".

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <unordered_map>

#include "model/scene/child.hpp"
#include "model/scene/faults.hpp"
#include "model/scene/multilinear.hpp"
#include "model/scene/shape.hpp"

namespace femsph {
namespace {

constexpr int gmsh_line = 1, gmsh_quad = 3, gmsh_hex = 5;
// Place of Gmsh's vertices, which go around a face, in lexicographic order.
constexpr std::array<int, 8> around_to_lexicographic = {0, 1, 3, 2, 4, 5, 7, 6};

// Gmsh is one global state: open it, keep it silent, and close it again.
class GmshSession {
 public:
  GmshSession() {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
  }
  ~GmshSession() {
    try {
      gmsh::finalize();
    } catch (...) {  // nothing to save: the mesh has been copied, or is being refused
    }
  }
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
};

struct Block {
  int type;
  std::vector<std::size_t> nodes;
};

std::vector<Block> elements(int dim, int entity = -1) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, nodes;
  gmsh::model::mesh::getElements(types, tags, nodes, dim, entity);
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < types.size(); ++i)
    if (!nodes[i].empty()) blocks.push_back({types[i], std::move(nodes[i])});
  return blocks;
}

std::string type_name(int type) {
  std::string name;
  int dim, order, nodes, primary;
  std::vector<double> coordinates;
  gmsh::model::mesh::getElementProperties(type, name, dim, order, nodes, coordinates, primary);
  return in_quotes(name);
}

// Gives vertices their numbers in the order of first use: unused ones are dropped.
class Vertices {
 public:
  explicit Vertices(double unit) {
    std::vector<std::size_t> tags;
    std::vector<double> x, parametric;
    gmsh::model::mesh::getNodes(tags, x, parametric, -1, -1, false, false);
    for (std::size_t i = 0; i < tags.size(); ++i) place_[tags[i]] = {x[3 * i] * unit, x[3 * i + 1] * unit, x[3 * i + 2] * unit};
  }
  int use(std::size_t tag, CellMesh& mesh) {
    const auto place = place_.find(tag);
    if (place == place_.end()) throw std::runtime_error(fmt::format("a cell uses vertex {}, which the file does not hold", tag));
    const auto [number, is_new] = number_.try_emplace(tag, int(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(place->second);
    return number->second;
  }
  int used(std::size_t tag) const {
    const auto number = number_.find(tag);
    return number == number_.end() ? -1 : number->second;
  }

 private:
  std::unordered_map<std::size_t, Point> place_;
  std::unordered_map<std::size_t, int> number_;
};

void require_cells_of_one_kind(const std::vector<Block>& blocks, int dim, const std::string& file) {
  const std::string expected = dim == 2 ? "linear quadrilaterals (in Gmsh: Recombine Surface, first order)"
                                        : "linear hexahedra (in Gmsh: transfinite or extruded recombined volumes, first order)";
  if (dim == 2 && !elements(3).empty())
    throw std::runtime_error(
        fmt::format("{} holds cells of type {} in a plane scene; expected {}", in_quotes(file), type_name(elements(3)[0].type), expected));
  for (const Block& block : blocks)
    if (block.type != (dim == 2 ? gmsh_quad : gmsh_hex))
      throw std::runtime_error(
          fmt::format("{} holds cells of type {}; expected only {}", in_quotes(file), type_name(block.type), expected));
  if (blocks.empty())
    throw std::runtime_error(fmt::format("{} holds no {}-dimensional cells; expected {}", in_quotes(file), dim, expected));
}

void require_finite(const CellMesh& mesh, const std::string& file) {
  const auto usable = [](double x) { return std::abs(x) < 1e60; };  // false for nan; see to_si
  for (const Point& p : mesh.vertices)
    if (!std::all_of(p.begin(), p.end(), usable))
      throw std::runtime_error(fmt::format("{} has a vertex that is not finite; expected coordinates", in_quotes(file)));
}

// CAD kernels leave rounding in z, which must not enter the plane's kinematics.
void flatten(CellMesh& mesh, const std::string& file) {
  double size = 0;
  for (const Point& p : mesh.vertices) size = std::max({size, std::abs(p[0]), std::abs(p[1])});
  for (Point& p : mesh.vertices) {
    if (std::abs(p[2]) > 1e-9 * size)
      throw std::runtime_error(fmt::format("{} leaves the plane z = 0; expected a plane mesh in x and y", in_quotes(file)));
    p[2] = 0;
  }
}

// Turns mirrored cells (clockwise, or with the top below the bottom) and refuses folded ones: there the map from the
// reference cell has no inverse, and the shape functions no gradient.
void orient(CellMesh& mesh, std::array<int, 8>& cell, std::size_t number, const std::string& file) {
  Patch patch{mesh.dim, {}};
  const auto place_corners = [&] {
    for (int v = 0; v < patch.corner_count(); ++v) patch.corners[v] = mesh.vertices[cell[v]];
  };
  place_corners();
  if (measure(patch) < 0) {
    if (mesh.dim == 2)
      std::swap(cell[1], cell[2]);
    else
      std::swap_ranges(cell.begin(), cell.begin() + 4, cell.begin() + 4);
    place_corners();
  }
  if (!(smallest_corner_jacobian(patch) > 0))
    throw std::runtime_error(
        fmt::format("cell {} of {} is folded or flat (its Jacobian is not positive at every corner); expected convex cells", number + 1,
                    in_quotes(file)));
}

void read_cells(CellMesh& mesh, Vertices& vertices, const std::string& file) {
  const auto blocks = elements(mesh.dim);
  require_cells_of_one_kind(blocks, mesh.dim, file);
  const int corners = 1 << mesh.dim;
  for (const Block& block : blocks)
    for (std::size_t first = 0; first + corners <= block.nodes.size(); first += corners) {
      std::array<int, 8> cell{};
      for (int v = 0; v < corners; ++v) cell[around_to_lexicographic[v]] = vertices.use(block.nodes[first + v], mesh);
      mesh.cells.push_back(cell);
    }
  require_finite(mesh, file);
  if (mesh.dim == 2) flatten(mesh, file);
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) orient(mesh, mesh.cells[i], i, file);
}

// Places use these names in a space separated list beside the names of the bounding sides.
void require_usable_group(const std::string& name, const CellMesh& mesh, const std::string& file) {
  const std::vector<std::string> reserved = {"x-", "x+", "y-", "y+", "z-", "z+", "all"};
  const auto in = [&](const auto& list) { return std::find(list.begin(), list.end(), name) != list.end(); };
  const bool blank = std::any_of(name.begin(), name.end(), [](unsigned char c) { return c <= 0x20 || c == 0x7f; });
  if (blank || in(reserved) || in(mesh.groups))
    throw std::runtime_error(fmt::format("{} has a physical group {}; expected a name without blanks, not {}", in_quotes(file),
                                         in_quotes(name), in(mesh.groups) ? "used twice" : "x-, x+, .. or all"));
}

void read_facets(CellMesh& mesh, int entity, int group, const Vertices& vertices, const std::string& file) {
  const int corners = 1 << (mesh.dim - 1);
  for (const Block& block : elements(mesh.dim - 1, entity)) {
    if (block.type != (mesh.dim == 2 ? gmsh_line : gmsh_quad))
      throw std::runtime_error(fmt::format("physical group {} of {} holds facets of type {}; expected linear {}",
                                           in_quotes(mesh.groups[group]), in_quotes(file), type_name(block.type),
                                           mesh.dim == 2 ? "lines" : "quadrilaterals"));
    for (std::size_t first = 0; first + corners <= block.nodes.size(); first += corners) {
      CellMesh::Facet facet{{}, group};
      for (int v = 0; v < corners; ++v) facet.vertices[around_to_lexicographic[v]] = vertices.used(block.nodes[first + v]);
      if (std::count(facet.vertices.begin(), facet.vertices.begin() + corners, -1))
        throw std::runtime_error(
            fmt::format("physical group {} of {} has a facet that belongs to no cell", in_quotes(mesh.groups[group]), in_quotes(file)));
      mesh.facets.push_back(facet);
    }
  }
}

void read_groups(CellMesh& mesh, const Vertices& vertices, const std::string& file) {
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, mesh.dim - 1);
  for (const auto& [dim, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dim, tag, name);
    if (name.empty()) name = std::to_string(tag);
    require_usable_group(name, mesh, file);
    mesh.groups.push_back(name);
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(dim, tag, entities);
    for (const int entity : entities) read_facets(mesh, entity, int(mesh.groups.size()) - 1, vertices, file);
  }
}

// Gmsh takes whatever it does not recognise as a .geo script and runs it, so only the beginnings of the .msh format pass.
void require_msh_file(const std::string& file) {
  std::error_code status;
  if (!std::filesystem::exists(file, status))
    throw std::runtime_error(fmt::format("no such file {}; expected a .msh file of Gmsh", in_quotes(file)));
  std::string start(20, ' ');
  if (std::filesystem::is_regular_file(file, status))
    std::ifstream(file, std::ios::binary).read(start.data(), std::streamsize(start.size()));
  const bool is_msh = start.starts_with("$MeshFormat") || start.starts_with("$Comments") || start.starts_with("$NOD");
  if (!is_msh || std::filesystem::path(file).extension() != ".msh")
    throw std::runtime_error(fmt::format("{} is not a .msh file; expected a mesh saved by Gmsh", in_quotes(file)));
}

CellMesh read_here(const std::string& file, int dim, double unit) {
  CellMesh mesh;
  mesh.dim = dim;
  try {
    const GmshSession session;
    gmsh::open(file);
    Vertices vertices(unit);
    read_cells(mesh, vertices, file);
    read_groups(mesh, vertices, file);
  } catch (const std::runtime_error&) {
    throw;
  } catch (...) {  // the API throws whatever its version likes: int, std::string, ..
    throw std::runtime_error(fmt::format("{} cannot be read by Gmsh; expected a mesh saved by Gmsh", in_quotes(file)));
  }
  return mesh;
}

// The mesh as bytes: the lengths of its lists, then what they hold. Or a message.
template <class T>
void put(std::string& bytes, const std::vector<T>& list) {
  const std::size_t n = list.size();
  bytes.append(reinterpret_cast<const char*>(&n), sizeof n);
  if (n > 0) bytes.append(reinterpret_cast<const char*>(list.data()), n * sizeof(T));
}

template <class T>
std::vector<T> take(const std::string& bytes, std::size_t& at) {
  std::size_t n = 0;
  std::memcpy(&n, bytes.data() + at, sizeof n);
  std::vector<T> list(n);
  if (n > 0) std::memcpy(list.data(), bytes.data() + at + sizeof n, n * sizeof(T));  // an empty list may hold no address
  at += sizeof n + n * sizeof(T);
  return list;
}

constexpr char is_mesh = 'm', is_message = 'x';

std::string to_bytes(const CellMesh& mesh) {
  std::string bytes(1, is_mesh);
  put(bytes, mesh.vertices);
  put(bytes, mesh.cells);
  put(bytes, mesh.facets);
  for (const std::string& group : mesh.groups) put(bytes, std::vector<char>(group.begin(), group.end()));
  return bytes;
}

CellMesh from_bytes(const std::string& bytes, int dim) {
  CellMesh mesh;
  std::size_t at = 1;
  mesh.dim = dim;
  mesh.vertices = take<Point>(bytes, at);
  mesh.cells = take<std::array<int, 8>>(bytes, at);
  mesh.facets = take<CellMesh::Facet>(bytes, at);
  while (at < bytes.size()) {
    const std::vector<char> group = take<char>(bytes, at);
    mesh.groups.emplace_back(group.begin(), group.end());
  }
  return mesh;
}

}  // namespace

CellMesh read_gmsh(const std::string& file, int dim, double unit) {
  require_msh_file(file);
  const std::size_t size = std::filesystem::file_size(file);
  const ChildLimits limits{unsigned(20 + size / 200'000), (std::size_t(1) << 30) + 100 * size};  // Gmsh reads some MB/s, and keeps some 20 bytes for each
  std::string bytes;
  const bool whole = in_child(
      [&] {
        try {
          return to_bytes(read_here(file, dim, unit));
        } catch (const std::runtime_error& e) {
          return is_message + std::string(e.what());
        }
      },
      limits, bytes);
  if (!whole || bytes.empty())
    throw std::runtime_error(fmt::format("{} cannot be read: it is damaged (Gmsh broke off); expected a mesh saved by Gmsh", in_quotes(file)));
  if (bytes[0] == is_message) throw std::runtime_error(bytes.substr(1));
  return from_bytes(bytes, dim);
}

}  // namespace femsph
