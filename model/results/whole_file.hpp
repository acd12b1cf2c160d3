#pragma once
// Internal to results/: how every file of a run reaches the disk.

#include <string>
#include <string_view>

namespace femsph {

/// Writes `file` in one piece: to a temporary name in the same folder, synced to the disk, then renamed.
/// Whoever reads `file` sees what was there before or all of `bytes`, also when the run is killed halfway
/// (which leaves FILE.PROCESS.part). A failure leaves no temporary behind and throws std::runtime_error
/// naming the file and the system's reason.
void write_whole(std::string_view bytes, const std::string& file);

/// Removes `file` if it exists; throws std::runtime_error if it then is still there.
void remove_file(const std::string& file);

/// Creates the folder and its parents; throws std::runtime_error if it then is no folder that files can be
/// written to.
void make_folder(const std::string& folder);

}  // namespace femsph
