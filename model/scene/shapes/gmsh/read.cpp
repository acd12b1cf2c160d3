// Reads a mesh file: cells, vertices and physical groups. Numbering of vertices and elements: Gmsh reference
// manual, "Node ordering" and "MSH file format".

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "femsph_provenance.hpp"
#include "model/input/faults.hpp"
#include "model/scene/shapes/gmsh/api.hpp"
#include "model/scene/shapes/gmsh/module.hpp"

namespace femsph {
namespace {

using namespace gmsh_reader;

void require_cells_of_one_kind(const std::vector<Block>& blocks, int dim, const std::string& file) {
  const std::string expected =
      dim == 2 ? "linear quadrilaterals (in Gmsh: Recombine Surface, first order)"
               : "linear hexahedra (in Gmsh: transfinite or extruded recombined volumes, first order)";
  if (dim == 2 && !elements(3).empty())
    throw std::runtime_error(fmt::format("{} holds cells of type {} in a plane scene; expected {}",
                                         in_quotes(file), type_name(elements(3)[0].type), expected));
  for (const Block& block : blocks)
    if (block.type != (dim == 2 ? gmsh_quad : gmsh_hex))
      throw std::runtime_error(fmt::format(
          "{} holds cells of type {}; expected only {}", in_quotes(file), type_name(block.type), expected));
  if (blocks.empty())
    throw std::runtime_error(
        fmt::format("{} holds no {}-dimensional cells; expected {}", in_quotes(file), dim, expected));
}

void require_finite(const CellMesh& mesh, const std::string& file) {
  const auto usable = [](double x) { return std::abs(x) < 1e60; };  // false for nan; see to_si
  for (const Point& p : mesh.vertices)
    if (!std::all_of(p.begin(), p.end(), usable))
      throw std::runtime_error(
          fmt::format("{} has a vertex that is not finite; expected coordinates", in_quotes(file)));
}

// Meshes from CAD kernels have rounding errors in z, which must not enter the kinematics of a plane body.
void flatten(CellMesh& mesh, const std::string& file) {
  double size = 0;
  for (const Point& p : mesh.vertices) size = std::max({size, std::abs(p[0]), std::abs(p[1])});
  for (Point& p : mesh.vertices) {
    if (std::abs(p[2]) > 1e-9 * size)
      throw std::runtime_error(
          fmt::format("{} leaves the plane z = 0; expected a plane mesh in x and y", in_quotes(file)));
    p[2] = 0;
  }
}

// Versions 1 and 2 list a cell once for each of its physical groups, each time with a new number; those are
// merged. Other cells with the same vertices are an error.
void drop_repeated_cells(CellMesh& mesh, const MshFacts& facts, const std::string& file) {
  std::unordered_map<std::size_t, int> group;
  for (std::size_t i = 0; i < facts.groups.size(); ++i) group[facts.numbers[i]] = facts.groups[i];
  std::vector<std::pair<std::array<int, 8>, int>> sorted;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    sorted.emplace_back(mesh.cells[c], int(c));
    std::sort(sorted.back().first.begin(), sorted.back().first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<char> again(mesh.cells.size());
  for (std::size_t i = 0, j; i < sorted.size(); i = j) {
    for (j = i + 1; j < sorted.size() && sorted[j].first == sorted[i].first; ++j)
      for (std::size_t k = i; k < j; ++k) {
        const std::size_t a = mesh.cell_numbers[sorted[k].second], b = mesh.cell_numbers[sorted[j].second];
        again[sorted[j].second] = 1;
        if (!facts.lists_groups() || !group.count(a) || !group.count(b) || group[a] == group[b])
          throw std::runtime_error(fmt::format(
              "cells {} and {} of {} are one and the same, with the same vertices{}; expected each cell once",
              a, b, in_quotes(file), facts.lists_groups() ? " and in the same group" : ""));
      }
  }
  std::size_t kept = 0;
  for (std::size_t c = 0; c < again.size(); ++c)
    if (!again[c]) mesh.cells[kept] = mesh.cells[c], mesh.cell_numbers[kept++] = mesh.cell_numbers[c];
  mesh.cells.resize(kept);
  mesh.cell_numbers.resize(kept);
}

void read_cells(CellMesh& mesh, Vertices& vertices, const MshFacts& facts, const std::string& file) {
  const auto blocks = elements(mesh.dim);
  require_cells_of_one_kind(blocks, mesh.dim, file);
  const int corners = 1 << mesh.dim;
  for (const Block& block : blocks)
    for (std::size_t i = 0; (i + 1) * corners <= block.nodes.size(); ++i) {
      std::array<int, 8> cell{};
      for (int v = 0; v < corners; ++v)
        cell[around_to_lexicographic[v]] = vertices.use(block.nodes[i * corners + v], mesh);
      mesh.cells.push_back(cell);
      mesh.cell_numbers.push_back(block.numbers[i]);
    }
  require_finite(mesh, file);
  if (mesh.dim == 2) flatten(mesh, file);
  drop_repeated_cells(mesh, facts, file);
}

// Of two nodes with the same number Gmsh uses the first and writes a warning to its log; of two such elements
// it drops one without a warning.
void require_nothing_lost(const MshFacts& facts, const std::string& file) {
  std::vector<std::string> log;
  gmsh::logger::get(log);
  const std::string twice = "Skipping duplicate node ";
  for (const std::string& line : log)
    if (const auto at = line.find(twice); at != std::string::npos)
      throw std::runtime_error(fmt::format("{} defines node {} twice; expected each number once",
                                           in_quotes(file), line.substr(at + twice.size())));
  std::size_t read = 0;
  for (const Block& block : elements(-1)) read += block.numbers.size();
  if (read >= facts.elements) return;
  std::vector<std::size_t> numbers = facts.numbers;
  std::sort(numbers.begin(), numbers.end());
  const auto same = std::adjacent_find(numbers.begin(), numbers.end());
  throw std::runtime_error(
      same != numbers.end()
          ? fmt::format("{} defines element {} twice; expected each number once", in_quotes(file), *same)
          : fmt::format("{} announces {} elements, of which Gmsh finds {}; expected a mesh saved by Gmsh",
                        in_quotes(file), facts.elements, read));
}

CellMesh read_here(const std::string& file, int dim, double unit) {
  CellMesh mesh;
  mesh.dim = dim;
  try {
    const Session session;
    const MshFacts facts = scan_msh(file, [](int type) { return corners_of(type); });
    gmsh::open(file);
    require_nothing_lost(facts, file);
    Vertices vertices(unit, file);
    read_cells(mesh, vertices, facts, file);
    read_groups(mesh, vertices, facts, file);
  } catch (const std::runtime_error&) {
    throw;
  } catch (...) {  // the type of exceptions depends on the version of Gmsh: int, std::string, ..
    throw std::runtime_error(
        fmt::format("{} cannot be read by Gmsh; expected a mesh saved by Gmsh", in_quotes(file)));
  }
  return mesh;
}

constexpr GmshModule table{{FEMSPH_BUILD_ID}, read_here};

}  // namespace
}  // namespace femsph

extern "C" const femsph::ModuleHead* femsph_gmsh_module() { return &femsph::table; }
