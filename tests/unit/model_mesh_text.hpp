#pragma once
// Meshes as text: unit squares, with numbers of nodes and cells that are no indices, so that a message must
// take them from the file.

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <vector>

#include "model/scene/shapes/mesh.hpp"

namespace femsph::mesh_text {

/// Tests run side by side.
inline const std::string file = testing::TempDir() + "femsph_mesh_" + std::to_string(getpid()) + ".msh";

/// A mesh of version 2.2: lines as they stand in the file.
struct Text {
  std::vector<std::string> nodes, elements, names;

  void write(std::size_t announced_elements = 0) const {
    std::ofstream out(file);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    if (!names.empty()) out << "$PhysicalNames\n" << names.size() << '\n';
    for (const auto& name : names) out << name << '\n';
    if (!names.empty()) out << "$EndPhysicalNames\n";
    out << "$Nodes\n" << nodes.size() << '\n';
    for (const auto& node : nodes) out << node << '\n';
    out << "$EndNodes\n$Elements\n" << (announced_elements ? announced_elements : elements.size()) << '\n';
    for (const auto& element : elements) out << element << '\n';
    out << "$EndElements\n";
  }
};

inline CellMesh read(const Text& text, int dim = 2, const MeshOptions& options = {}) {
  text.write();
  return read_gmsh(file, dim, 1.0, options);
}

/// A message, with FILE for the quoted file.
inline std::string without_file(std::string what) {
  for (std::size_t at; (at = what.find('"' + file + '"')) != std::string::npos;)
    what.replace(at, file.size() + 2, "FILE");
  return what;
}

/// (0, 2) x (0, 1) of two squares, 31 and 32, with a line on the left and on the right.
inline Text two_squares() {
  return {{"11 0 0 0", "12 1 0 0", "13 2 0 0", "21 0 1 0", "22 1 1 0", "23 2 1 0"},
          {"31 3 2 5 1 11 12 22 21", "32 3 2 5 1 12 13 23 22", "41 1 2 1 7 11 21", "42 1 2 2 8 13 23"},
          {"1 1 \"left\"", "1 2 \"right\"", "2 5 \"plate\""}};
}

/// The same, its squares not joined: the right one has the vertices 52 and 53 on 12 and 22.
inline Text doubled(const std::string& x = "1") {
  return {{"11 0 0 0", "12 1 0 0", "13 2 0 0", "21 0 1 0", "22 1 1 0", "23 2 1 0", "52 " + x + " 0 0",
           "53 " + x + " 1 0"},
          {"31 3 2 5 1 11 12 22 21", "32 3 2 5 1 52 13 23 53"},
          {}};
}

}  // namespace femsph::mesh_text
