#include "model/numerics/module.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

namespace femsph {

std::string module_path(const std::string& name) {
  const std::string file = "lib" + name + ".so";
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  for (const char* where : {".", "../lib/femsph", "../.."}) {
    const auto path = (program.parent_path() / where / file).lexically_normal();
    if (std::filesystem::exists(path)) return path.string();
  }
  throw std::runtime_error("the module " + file + " of " + program.filename().string() +
                           " is missing; expected beside the program in " + program.parent_path().string() +
                           " or in ../lib/femsph: build or install femsph whole");
}

const ModuleHead* open_module(const std::string& name, const char* build) {
  const std::string path = module_path(name);
  void* module = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!module) throw std::runtime_error("the module " + path + " cannot be opened: " + dlerror());
  const auto table = reinterpret_cast<const ModuleHead* (*)()>(dlsym(module, (name + "_module").c_str()));
  if (!table) throw std::runtime_error(path + " is no module of femsph: build or install femsph whole");
  const ModuleHead* head = table();
  if (std::string(head->build) != build)
    throw std::runtime_error("the module " + path + " belongs to another build of femsph (" + head->build +
                             "; expected " + build + "): build or install femsph whole");
  return head;
}

}  // namespace femsph
