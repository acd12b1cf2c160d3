#pragma once
// A run on disk, whole, to be taken up again: one HDF5 file, with a last line that says how long it is and
// what its bytes add up to.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/numerics/archive.hpp"

namespace femsph {

/// What to start again from, before any state is put back.
struct RunOrigin {
  std::string scene_file, scene_path,
      scene_text;                      ///< as the user gave it; absolute, for mesh files; its bytes
  std::vector<std::string> arguments;  ///< of the command line, the program first
  std::uint64_t meshes = 0;            ///< checksum of the scene's mesh files as they were read
  std::string progress;                ///< "step 1200 of 4000"
};

/// Writes `file` in one piece, to a temporary name that is then renamed: the checkpoint before stays until
/// this one is whole. `visit` names the state. Throws std::runtime_error naming the file and the system's
/// reason.
void write_checkpoint(const std::string& file, const RunOrigin& origin,
                      const std::function<void(Archive&)>& visit);

class Checkpoint {
 public:
  /// Reads and checks the file. Throws InputError: none there, cut short, damaged, of another format or
  /// (unless `any_program`) of another program.
  Checkpoint(const std::string& file, bool any_program);
  const RunOrigin& origin() const { return origin_; }
  const std::string& file() const { return file_; }
  /// Puts the state back. Throws InputError where it does not fit.
  void restore(const std::function<void(Archive&)>& visit) const;

 private:
  std::string file_, bytes_;
  RunOrigin origin_;
};

/// Sixty-four bits of the bytes: any changed word changes them.
std::uint64_t checksum(std::string_view bytes, std::uint64_t seed = 0);

}  // namespace femsph
