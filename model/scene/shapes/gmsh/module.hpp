#pragma once
// The functions of the module that reads meshes with the library of Gmsh.

#include <string>

#include "model/numerics/module.hpp"
#include "model/scene/shapes/shape.hpp"

namespace femsph {

struct GmshModule : ModuleHead {
  /// Throws std::runtime_error with one sentence. Gmsh may crash: call it in a child process.
  CellMesh (*read)(const std::string& file, int dim, double unit);
};

}  // namespace femsph
