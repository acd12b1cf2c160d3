#pragma once
// The few calls of Gmsh's API that the reader of meshes makes; only the sources of this
// module include this.

#include <string>
#include <unordered_map>
#include <vector>

#include "model/scene/shapes/gmsh/msh_scan.hpp"
#include "model/scene/shapes/shape.hpp"

namespace femsph::gmsh_reader {

constexpr int gmsh_line = 1, gmsh_quad = 3, gmsh_hex = 5;
// Place of Gmsh's vertices, which go around a face, in lexicographic order.
constexpr std::array<int, 8> around_to_lexicographic = {0, 1, 3, 2, 4, 5, 7, 6};

/// Gmsh is one global state: opens it, keeps it silent, and closes it again.
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

/// Gives vertices their numbers in the order of first use: unused ones are dropped.
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

/// The groups of facets, and what places may call them; nothing here makes a mesh unusable.
void read_groups(CellMesh& mesh, const Vertices& vertices, const MshFacts& facts, const std::string& file);

}  // namespace femsph::gmsh_reader
