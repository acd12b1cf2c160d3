#pragma once
// Reads a scene file. Everything wrong with it is found in one go.

#include <stdexcept>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"

namespace femsph {

/// One fault of an input file: "file:line:column: what is wrong; what was expected; did you mean".
struct Fault {
  int line, column;
  std::string text;
};

/// All faults of a file, in the order of their lines; what() is the whole message, one line per fault.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// Throws InputError.
Scene read_scene(const std::string& file);
/// The same from memory; `file` names it in messages, and relative mesh paths start at its folder.
Scene parse_scene(const std::string& text, const std::string& file);

}  // namespace femsph
