#pragma once
// Internal to results/: how files are written.

#include <string>
#include <string_view>

namespace femsph {

/// Writes `file` to a temporary name in the same folder, syncs it to the disk and renames it. So `file`
/// always has its old content or all of `bytes`, even if the run is killed (which leaves FILE.PROCESS.part).
/// On failure it removes the temporary file and throws std::runtime_error with the file and the system's
/// reason.
void write_whole(std::string_view bytes, const std::string& file);

/// Removes `file` if it exists; throws std::runtime_error if it cannot be removed.
void remove_file(const std::string& file);

/// Creates the folder and its parents; throws std::runtime_error if it is then not a writable folder.
void make_folder(const std::string& folder);

}  // namespace femsph
