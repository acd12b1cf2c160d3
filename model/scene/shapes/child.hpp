#pragma once
// Runs a function in a child process, so that a library that crashes does not end the program.

#include <cstddef>
#include <functional>
#include <string>

namespace femsph {

struct ChildLimits {
  unsigned seconds;   ///< of CPU time of the child; twenty times as many of wall time
  std::size_t bytes;  ///< of memory, in addition to that of this process
};

/// Calls work() in a child process and puts what it returns into `result`. False if the child crashed,
/// exceeded a limit, or could not be started; an exception of work() counts as a crash. prepare() is called
/// in the child first, without limits; it must not throw. Output of the child is discarded.
bool in_child(const std::function<std::string()>& work, const ChildLimits& limits, std::string& result,
              const std::function<void()>& prepare = {});

}  // namespace femsph
