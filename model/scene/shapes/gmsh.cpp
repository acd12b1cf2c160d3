// Reads meshes with the library of Gmsh, so that every version of the .msh format works. The library does not
// check its input: with a damaged file it may read beyond its arrays or allocate all memory. Therefore it
// runs in a child process, which returns the mesh; only that process opens the module that is linked to Gmsh
// (gmsh/).

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "femsph_provenance.hpp"
#include "model/input/faults.hpp"
#include "model/scene/shapes/child.hpp"
#include "model/scene/shapes/gmsh/module.hpp"
#include "model/scene/shapes/mesh_bytes.hpp"
#include "model/scene/shapes/mesh_check.hpp"

namespace femsph {
namespace {

// Gmsh executes every file of unknown format as a .geo script, so files that do not begin like a .msh file
// are refused.
void require_msh_file(const std::string& file) {
  std::error_code status;
  if (!std::filesystem::exists(file, status))
    throw std::runtime_error(fmt::format("no such file {}; expected a .msh file of Gmsh", in_quotes(file)));
  std::string start(20, ' ');
  if (std::filesystem::is_regular_file(file, status))
    std::ifstream(file, std::ios::binary).read(start.data(), std::streamsize(start.size()));
  const bool is_msh = start.starts_with("$MeshFormat") || start.starts_with("$Comments") ||
                      start.starts_with("$NOD");
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  if (!is_msh || extension != ".msh")
    throw std::runtime_error(
        fmt::format("{} is not a .msh file; expected a mesh saved by Gmsh", in_quotes(file)));
}

constexpr char is_mesh = 'm', is_message = 'x';

}  // namespace

CellMesh read_gmsh(const std::string& file, int dim, double unit, const MeshOptions& options) {
  require_msh_file(file);
  const std::size_t size = std::filesystem::file_size(file);
  const ChildLimits limits{
      unsigned(20 + size / 200'000),
      (std::size_t(1) << 30) +
          100 * size};  // Gmsh reads a few MB/s, and needs about 20 bytes of memory for each byte
  std::string bytes, trouble;
  const GmshModule* gmsh = nullptr;
  const auto open = [&] {
    try {
      gmsh = static_cast<const GmshModule*>(open_module("femsph_gmsh", FEMSPH_BUILD_ID));
    } catch (const std::runtime_error& e) {
      trouble = e.what();
    }
  };
  const auto read = [&] {
    try {
      return gmsh ? is_mesh + to_bytes(gmsh->read(file, dim, unit)) : is_message + trouble;
    } catch (const std::runtime_error& e) {
      return is_message + std::string(e.what());
    }
  };
  const bool whole = in_child(read, limits, bytes, open);
  if (!whole || bytes.empty())
    throw std::runtime_error(fmt::format(
        "{} cannot be read: it is damaged (Gmsh broke off); expected a mesh saved by Gmsh", in_quotes(file)));
  if (bytes[0] == is_message) throw std::runtime_error(bytes.substr(1));
  CellMesh mesh = from_bytes(bytes, 1, dim);
  check_mesh(mesh, options, file);
  return mesh;
}

}  // namespace femsph
