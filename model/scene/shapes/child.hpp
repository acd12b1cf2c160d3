#pragma once
// Work that a library may not survive, in a process of its own.

#include <cstddef>
#include <functional>
#include <string>

namespace femsph {

struct ChildLimits {
  unsigned seconds;   ///< of its own CPU, and twenty times as many of the clock
  std::size_t bytes;  ///< of memory beyond what this process holds
};

/// What `work` returns, computed in a child process after `prepare`, which the limits do not count (and which
/// must not throw); nothing if the child crashed, ran out of time or memory, or could not be started. An
/// exception of work ends the child like a crash. What the child prints is lost.
bool in_child(const std::function<std::string()>& work, const ChildLimits& limits, std::string& result,
              const std::function<void()>& prepare = {});

}  // namespace femsph
