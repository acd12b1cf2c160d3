#pragma once
// Checkpoints: the complete state of a run in one HDF5 file, which ends with a line that has its length and
// checksum.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/numerics/archive.hpp"

namespace femsph {

/// What is needed to set up the run again, before its state is restored.
struct RunOrigin {
  std::string scene_file, scene_path,
      scene_text;  ///< the path as given by the user; the absolute path, for mesh files; the content
  std::vector<std::string> arguments;  ///< of the command line, the program first
  std::uint64_t meshes = 0;            ///< checksum of the scene's mesh files as they were read
  std::string progress;                ///< "step 1200 of 4000"
};

/// Writes `file` under a temporary name that is then renamed, so that the previous checkpoint remains until
/// this one is complete. `visit` lists the state. Throws std::runtime_error with the file and the system's
/// reason.
void write_checkpoint(const std::string& file, const RunOrigin& origin,
                      const std::function<void(Archive&)>& visit);

class Checkpoint {
 public:
  /// Reads and checks the file. Throws InputError if it does not exist, is incomplete or damaged, has another
  /// format, or (unless `any_program`) was written by another build.
  Checkpoint(const std::string& file, bool any_program);
  const RunOrigin& origin() const { return origin_; }
  const std::string& file() const { return file_; }
  /// Restores the state. Throws InputError if it does not fit.
  void restore(const std::function<void(Archive&)>& visit) const;

 private:
  std::string file_, bytes_;
  RunOrigin origin_;
};

/// A checksum of 64 bits.
std::uint64_t checksum(std::string_view bytes, std::uint64_t seed = 0);

}  // namespace femsph
