#pragma once
// The files of a run: fields and checkpoints while it runs, histories and the record at its end, however it
// ends.

#include <memory>
#include <string>
#include <vector>

#include "compare/run/interruption.hpp"
#include "compare/run/run.hpp"
#include "model/results/fields.hpp"
#include "model/results/record.hpp"
#include "model/results/recorder.hpp"

namespace femsph::compare {

/// DIR/checkpoint.h5
std::string checkpoint_file(const std::string& folder);
/// Whether the folder holds a record.toml that a run has written.
bool has_record(const std::string& folder);
/// Checksum of the cells of all bodies that have some (mesh files, and shapes made of cells).
std::uint64_t checksum_of_meshes(const Scene& scene);

class RunOutput {
 public:
  /// Restores march and recorder from options.checkpoint->from, if there is one; else removes the files of an
  /// earlier run from the folder. All but `options` must outlive this. `start_cpu`: CPU time of the process
  /// when the run began, s.
  RunOutput(const BodyMethods& methods, const RunOptions& options, March& march, Recorder& recorder,
            double start_cpu);

  /// CPU seconds of the run, set-up included, before the checkpoint that it continues from.
  double cpu_before() const { return cpu_before_; }

  void snapshot();
  /// Between two steps: writes a checkpoint when one is due. After an interruption writes one and throws
  /// Interrupted.
  void between();
  /// Writes histories and the record; `whole`: the run came to its end, so also profiles and energies, and
  /// the checkpoint is removed.
  void finish(const std::string& outcome, bool whole);
  /// The same of a run that an exception ended, as far as they can be written: errors in writing must not
  /// hide that exception.
  void try_to_finish(const std::string& outcome) noexcept;
  /// After a watch has stopped the march: writes the fields of the last state that passed all watches.
  /// Returns a sentence that says where they are.
  std::string save_last_good();

 private:
  void save();
  void price_state(Archive& archive);
  void state(Archive& archive);

  const BodyMethods methods_;
  const RunOptions options_;
  March& march_;
  Recorder& recorder_;
  std::string folder_;
  RunRecord record_;
  RunOrigin origin_;
  std::unique_ptr<FieldWriter> fields_;
  std::vector<std::size_t> ids_;
  AlignedVector<double> velocity_;  ///< of a body, at the whole step
  Interruption interruption_;
  double start_cpu_, cpu_before_ = 0;  ///< s
  double saved_at_;                    ///< wall seconds
  std::string saved_progress_;         ///< of the last complete checkpoint; empty: none
};

}  // namespace femsph::compare
