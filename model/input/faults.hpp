#pragma once
// Errors ("faults") in input files, collected so that the user sees all of them at once.

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace femsph {

/// A position in a file, counted from 1; line 0: not from a file.
struct Source {
  int line = 0, column = 0;
};

/// One fault of an input file; `text` is "what is wrong; what was expected; did you mean".
struct Fault {
  int line, column;
  std::string text;
};

/// All faults of a file, in the order of their lines; what() is the whole message, one line per fault:
/// "file:line:column: what is wrong; what was expected; did you mean" (without line and column for the file
/// as a whole).
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// A method cannot run a scene that is correct. The message is one sentence. Thrown before the first step.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The faults found so far while a file is read.
class Faults {
 public:
  void add(Source at, std::string text) { list_.push_back({at.line, at.column, std::move(text)}); }
  bool empty() const { return list_.empty(); }
  std::size_t size() const { return list_.size(); }
  /// Throws InputError if anything was added.
  void raise(const std::string& file) const {
    if (!list_.empty()) throw InputError(file, list_);
  }

 private:
  std::vector<Fault> list_;
};

/// `text` in double quotes for a message: control characters escaped and long texts cut, so that a fault
/// stays one line.
std::string in_quotes(std::string_view text);

/// "a", "b" or "c" (quoted), for messages.
std::string one_of(const std::vector<std::string>& names);

/// "; did you mean "x"?" with the name that is most similar to `word`; empty if none is similar, that is, if
/// more than a third of its letters (and more than one) are inserted, removed, replaced or swapped with a
/// neighbour.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace femsph
