#pragma once
// Modules: shared objects that the program opens when they are needed. Code that uses a library which is slow
// to load (deal.II with its 200 libraries takes a quarter of a second; Gmsh) is built as a module, so that
// the program starts quickly without it. A module has one exported function, NAME_module(), which returns a
// table of its functions. Functions of the program that it calls are exported by the program (CMake's
// ENABLE_EXPORTS).

#include <string>

namespace femsph {

/// The first member of the table of every module.
struct ModuleHead {
  const char* build;  ///< FEMSPH_BUILD_ID of the module; that of the program must be equal
};

/// "version, git state, build type, flags" of the file that includes femsph_provenance.hpp.
#define FEMSPH_BUILD_ID FEMSPH_VERSION ", " FEMSPH_GIT ", " FEMSPH_BUILD_TYPE ", " FEMSPH_FLAGS

/// The path of module `name`: beside the program, in ../lib/femsph (installed), or two folders up (programs
/// in tests/ of a build folder). Throws std::runtime_error if it does not exist.
std::string module_path(const std::string& name);

/// Opens lib`name`.so and returns its table. It stays open. Throws std::runtime_error with advice if there is
/// none, or one of another build than `build`.
const ModuleHead* open_module(const std::string& name, const char* build);

}  // namespace femsph
