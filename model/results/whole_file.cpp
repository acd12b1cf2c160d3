#include "model/results/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace femsph {

namespace {

[[noreturn]] void fail(const std::string& file, int reason) {
  throw std::runtime_error(fmt::format("cannot write {}: {}", file, std::strerror(reason)));
}

/// A file with a temporary name, which is removed unless it has been renamed.
class Temporary {
 public:
  /// The process number makes the name unique if two runs write to the same folder.
  explicit Temporary(const std::string& file)
      : file_(file), name_(fmt::format("{}.{}.part", file, ::getpid())) {
    descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail(file_, errno);
  }
  ~Temporary() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }
  Temporary(const Temporary&) = delete;

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail(file_, errno);
      bytes.remove_prefix(n);
    }
  }

  /// A full disk may be reported only by fsync or close (delayed allocation, network file systems), so both
  /// are checked.
  void rename() {
    if (::fsync(descriptor_) != 0 && errno != EINVAL)
      fail(file_, errno);  // EINVAL: a file system that cannot sync
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail(file_, errno);
    if (::rename(name_.c_str(), file_.c_str()) != 0) fail(file_, errno);
    renamed_ = true;
  }

 private:
  std::string file_, name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

/// Renaming would replace a link or a device: links are followed, devices refused.
std::string target(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path path = fs::is_symlink(file, none) && fs::exists(file, none) ? fs::canonical(file, none)
                                                                             : fs::path(file);
  const fs::file_status status = fs::status(path, none);
  if (fs::is_directory(status)) fail(file, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw std::runtime_error(fmt::format("cannot write {}: not a regular file", file));
  return path;
}

}  // namespace

void write_whole(std::string_view bytes, const std::string& file) {
  Temporary temporary(target(file));
  temporary.write(bytes);
  temporary.rename();
}

void remove_file(const std::string& file) {
  if (::unlink(file.c_str()) != 0 && errno != ENOENT)
    throw std::runtime_error(fmt::format("cannot remove {}: {}", file, std::strerror(errno)));
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(fmt::format("cannot create folder {}: {}", folder, error.message()));
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail("into folder " + folder, errno);
}

}  // namespace femsph
