#pragma once
// The run record: everything needed to repeat a run and to judge it, as TOML.

#include <string>
#include <utility>
#include <vector>

#include "model/motion/bodies/ledger.hpp"
#include "model/motion/bodies/price.hpp"

namespace femsph {

/// Version, git state, compiler, flags, libraries, machine: one "key = value" each.
std::vector<std::pair<std::string, std::string>> provenance();
/// Adds a key to provenance(), or overwrites it; for libraries that this folder does not use, such as
/// deal.II.
void add_provenance(std::string key, std::string value);
/// "femsph 0.1.0 (git 1a2b3c4, modified)"
std::string version_line();

struct RunRecord {
  std::string scene_file, scene_text, method, command;
  std::vector<std::pair<std::string, std::string>>
      derived;  ///< particles, elements, critical step, effects, ..
  std::vector<std::string> warnings;
  Ledger ledger;
  Price price;
  std::string outcome;      ///< "finished", "settled", or the message that stopped it
  std::string finished_at;  ///< ISO 8601, UTC
};

/// DIR/record.toml and DIR/scene.toml (the scene as given, byte for byte). Creates DIR.
/// Throws std::runtime_error naming the file and the system's reason.
void write_record(const RunRecord& record, const std::string& folder);

/// A progress line (step, time, rate, time left) on stderr; nothing if stderr is no terminal.
class Progress {
 public:
  explicit Progress(std::string what);
  /// Clears the line, so that other output starts on an empty one.
  ~Progress();
  Progress(const Progress&) = delete;
  /// Can be called in every step: it prints at most five times a second. `steps`: the largest number of
  /// steps; 0: not known.
  void show(long step, long steps, double time);

 private:
  std::string what_;
  double start_ = 0, last_;  ///< wall seconds of the first call and of the last line
  long first_ = -1;          ///< step of the first call
  bool terminal_, shown_ = false;
};

/// "beam: step 1200 of 4000, t = 0.0123 s, 812 steps/s, 3 s left"
std::string progress_line(const std::string& what, long step, long steps, double time,
                          double steps_per_second);

}  // namespace femsph
