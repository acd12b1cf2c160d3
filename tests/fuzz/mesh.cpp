// Any bytes as a mesh: cells that shapes can use, or a std::runtime_error. Gmsh works in a child process,
// where this fuzzer sees no coverage: this checks that no failure of Gmsh reaches the parent, and that
// returned cells are valid.

#include "model/scene/shapes/mesh.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const std::string file = "/dev/shm/femsph_fuzz_" + std::to_string(getpid()) + ".msh";
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), std::streamsize(size));
  for (const int dim : {2, 3}) {
    try {
      const femsph::MeshShape shape(femsph::read_gmsh(file, dim, 1e-3), "mesh.msh");
      if (!(shape.measure() > 0)) std::abort();
      shape.contains(shape.lower(), 1e-9);
    } catch (const std::runtime_error&) {
    }
  }
  std::remove(file.c_str());
  return 0;
}
