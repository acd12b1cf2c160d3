#pragma once
// The calls of Gmsh's API that reading a mesh needs. Only the sources of this folder include this.

#include <string>
#include <unordered_map>
#include <vector>

#include "model/scene/shapes/gmsh/msh_scan.hpp"
#include "model/scene/shapes/shape.hpp"

namespace femsph::gmsh_reader {

constexpr int gmsh_line = 1, gmsh_quad = 3, gmsh_hex = 5;
// Gmsh numbers the vertices of a cell around a face; this maps them to lexicographic order.
constexpr std::array<int, 8> around_to_lexicographic = {0, 1, 3, 2, 4, 5, 7, 6};

/// Initializes the library, which has one global state, without output; and finalizes it.
class Session {
 public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

/// Elements of one type: their numbers, and their nodes one after the other.
struct Block {
  int type;
  std::vector<std::size_t> numbers, nodes;
};

std::vector<Block> elements(int dim, int entity = -1);
std::string type_name(int type);  ///< in quotes
int corners_of(int type);

/// Numbers the vertices in the order of their first use, so that unused ones are dropped.
class Vertices {
 public:
  Vertices(double unit, const std::string& file);
  int use(std::size_t tag, CellMesh& mesh);
  int used(std::size_t tag) const;  ///< -1: by no cell

 private:
  const std::string& file_;
  std::unordered_map<std::size_t, Point> place_;
  std::unordered_map<std::size_t, int> number_;
};

/// Reads the physical groups of facets, and the words by which places can refer to them. An unusable group is
/// an error only where a place refers to it.
void read_groups(CellMesh& mesh, const Vertices& vertices, const MshFacts& facts, const std::string& file);

}  // namespace femsph::gmsh_reader
