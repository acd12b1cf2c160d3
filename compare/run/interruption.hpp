#pragma once
// SIGINT and SIGTERM during a run set a flag, which the time loop reads between two steps.

#include <stdexcept>
#include <string>

namespace femsph::compare {

/// The user has interrupted the run; its checkpoint holds all that is needed to continue.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// While an object of this class exists, the first signal sets the flag, and a second one ends the program.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  bool asked() const;  ///< whether the flag is set
};

}  // namespace femsph::compare
