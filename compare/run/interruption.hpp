#pragma once
// SIGINT and SIGTERM during a run: a flag that the march's loop looks at between two steps.

#include <stdexcept>
#include <string>

namespace femsph::compare {

/// A run that left at the user's wish, with all that it needs to go on in a checkpoint.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// While one of these lives, the first signal sets the flag, and a second one ends the program as usual.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  bool asked() const;
};

}  // namespace femsph::compare
