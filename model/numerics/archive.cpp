#include "model/numerics/archive.hpp"

#include <cstring>
#include <stdexcept>

namespace femsph {

void Archive::misfit(std::string_view name) const {
  throw std::runtime_error(
      "a saved state does not fit this run: \"" + path_ + std::string(name) + "\" has another size");
}

// The length comes before every block, so that a state that does not fit is detected.

void MemoryArchive::Pass::block(std::string_view name, Kind, void* data, std::size_t count) {
  const std::size_t size = count * sizeof(double);
  if (restoring()) {
    if (length(name, count) != count) misfit(name);
    if (size > 0) std::memcpy(data, bytes_.data() + at_ + sizeof count, size);
  } else {
    bytes_.resize(at_ + sizeof count + size);
    std::memcpy(bytes_.data() + at_, &count, sizeof count);
    if (size > 0) std::memcpy(bytes_.data() + at_ + sizeof count, data, size);
  }
  at_ += sizeof count + size;
}

std::size_t MemoryArchive::Pass::length(std::string_view name, std::size_t now) {
  if (!restoring()) return now;
  std::size_t count = 0;
  if (at_ + sizeof count > bytes_.size()) misfit(name);
  std::memcpy(&count, bytes_.data() + at_, sizeof count);
  if (count > (bytes_.size() - at_ - sizeof count) / sizeof(double)) misfit(name);
  return count;
}

}  // namespace femsph
