#pragma once
// Modules: shared objects that a program opens when it first needs them. What uses a library that is slow to
// load (deal.II: a quarter of a second for its 200 libraries; Gmsh) is built as one, so that a program which
// does without it starts at once. A module has one function, NAME_module(), which returns a table of its
// functions. What it calls of the program itself it finds there: programs export their symbols (CMake's
// ENABLE_EXPORTS).

#include <string>

namespace femsph {

/// What a module's table begins with.
struct ModuleHead {
  const char* build;  ///< of which build the module is; equal to the program's
};

/// "version, git state, build type, flags" of the file that includes femsph_provenance.hpp.
#define FEMSPH_BUILD_ID FEMSPH_VERSION ", " FEMSPH_GIT ", " FEMSPH_BUILD_TYPE ", " FEMSPH_FLAGS

/// The path of module `name`: beside the program, in ../lib/femsph (installed), or two folders up (programs
/// in tests/ of a build tree). Throws std::runtime_error if it is nowhere.
std::string module_path(const std::string& name);

/// Opens lib`name`.so and returns its table, whose build is `build`. It stays open. Throws
/// std::runtime_error, which says what to do.
const ModuleHead* open_module(const std::string& name, const char* build);

}  // namespace femsph
