#pragma once
// What a run leaves in its folder: fields and checkpoints as it goes, histories and the record at its end,
// however it ends.

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
/// DIR/record.toml is there, and a run has written it.
bool has_record(const std::string& folder);
/// Of the cells that the scene's bodies bring along.
std::uint64_t checksum_of_meshes(const Scene& scene);

class RunOutput {
 public:
  /// Takes up options.checkpoint->from, if there is one: then march and recorder are where it left them. All
  /// but `options` must outlive this. Of a new run, removes what an earlier one has left in the folder.
  /// `start_cpu`: the process's clock when the run began.
  RunOutput(const Method& method, const RunOptions& options, March& march, Recorder& recorder,
            double start_cpu);

  /// CPU seconds that the run had cost, set-up included, before it was taken up.
  double cpu_before() const { return cpu_before_; }

  void snapshot();
  /// Between two steps: writes a checkpoint when one is due. Throws Interrupted after that of an
  /// interruption.
  void between();
  /// Histories and the record; `whole`: with what holds only for a run that came to its end, and the
  /// checkpoint has served its time.
  void finish(const std::string& outcome, bool whole);
  /// The histories and the record of a run that something else ended, as far as they can be written: its
  /// cause is what will be told.
  void try_to_finish(const std::string& outcome) noexcept;
  /// After a watch has stopped the march: the fields of the last state found sound. Returns a sentence that
  /// says where they are.
  std::string save_last_good();

 private:
  void save();
  void price_state(Archive& archive);
  void state(Archive& archive);

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
  std::string saved_progress_;         ///< of the last whole checkpoint; empty: none
};

}  // namespace femsph::compare
