#pragma once
// The run record: everything needed to repeat a run and to judge it, as TOML.

#include <string>
#include <vector>

#include "model/motion/ledger.hpp"
#include "model/results/price.hpp"

namespace femsph {

/// Version, git state, compiler, flags, libraries, machine: one "key = value" each.
std::vector<std::pair<std::string, std::string>> provenance();
/// "femsph 0.1.0 (git 1a2b3c4, modified)"
std::string version_line();

struct RunRecord {
  std::string scene_file, scene_text, method, command;
  std::vector<std::pair<std::string, std::string>> derived;  ///< particles, elements, critical step, effects, ..
  Ledger ledger;
  Price price;
  std::string outcome;  ///< "finished", "settled", or the message that stopped it
  std::string finished_at;  ///< ISO 8601, UTC
};

/// DIR/record.toml and DIR/scene.toml (the scene as given, byte for byte).
void write_record(const RunRecord& record, const std::string& folder);

/// A progress line (step, time, rate, time left) on a terminal; silent when stderr is none.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();
  void show(long step, long steps, double time);

 private:
  std::string what_;
  double start_, last_;
  bool terminal_, shown_ = false;
};

}  // namespace femsph
