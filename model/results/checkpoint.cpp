#include "model/results/checkpoint.hpp"

#include <cstring>
#include <filesystem>
#include <fstream>

#include "model/input/faults.hpp"
#include "model/results/hdf5.hpp"
#include "model/results/record.hpp"
#include "model/results/whole_file.hpp"

namespace femsph {

namespace {

constexpr int format = 1;

/// The last line, which HDF5 ignores: "femsph checkpoint 12345 bytes 0123456789abcdef".
std::string tail_of(std::string_view bytes) {
  return fmt::format("\nfemsph checkpoint {:20} bytes {:016x}\n", bytes.size(), checksum(bytes));
}

/// The version, and a checksum of the program file: results are the same to the last bit only with the same
/// code.
std::string program() {
  static const std::string name = [] {
    std::ifstream in("/proc/self/exe", std::ios::binary);
    std::vector<char> part(1 << 20);
    std::uint64_t sum = 0;
    while (in.read(part.data(), std::streamsize(part.size())) || in.gcount() > 0)
      sum = checksum({part.data(), std::size_t(in.gcount())}, sum);
    return fmt::format("{}, build {:016x}", version_line(), sum);
  }();
  return name;
}

[[noreturn]] void refuse(const std::string& file, std::string text) {
  throw InputError(file, {Fault{0, 0, std::move(text)}});
}

class Saving final : public Archive {
 public:
  explicit Saving(hdf5::Image& image) : Archive(false), image_(image) {}

 private:
  void block(std::string_view name, Kind kind, void* data, std::size_t count) override {
    image_.dataset(
        "state/" + path() + std::string(name), kind == Kind::real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64,
        count ? data : nullptr, {count});
  }
  std::size_t length(std::string_view, std::size_t now) override { return now; }
  hdf5::Image& image_;
};

class Restoring final : public Archive {
 public:
  explicit Restoring(const hdf5::Opened& opened) : Archive(true), opened_(opened) {}

 private:
  void block(std::string_view name, Kind kind, void* data, std::size_t count) override {
    opened_.read("state/" + path() + std::string(name),
                 kind == Kind::real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64, data, count);
  }
  std::size_t length(std::string_view name, std::size_t) override {
    return opened_.length("state/" + path() + std::string(name));
  }
  const hdf5::Opened& opened_;
};

}  // namespace

std::uint64_t checksum(std::string_view bytes, std::uint64_t seed) {
  constexpr std::uint64_t prime = 0x100000001b3;  // FNV-1a, eight bytes at a time
  std::uint64_t sum = seed ^ 0xcbf29ce484222325;
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::size_t n = std::min(bytes.size(), sizeof word);
    std::memcpy(&word, bytes.data(), n);
    sum = (sum ^ word) * prime;
    sum ^= sum >> 32;  // so that high bits also affect lower ones
    bytes.remove_prefix(n);
  }
  return sum;
}

void write_checkpoint(const std::string& file, const RunOrigin& origin,
                      const std::function<void(Archive&)>& visit) {
  hdf5::Image image(file);
  image.attribute("/", "format", double(format));
  image.attribute("/", "program", program());
  image.attribute("/", "progress", origin.progress);
  image.text("origin/program", program());
  image.text("origin/scene_file", origin.scene_file);
  image.text("origin/scene_path", origin.scene_path);
  image.text("origin/scene_text", origin.scene_text);
  image.text("origin/progress", origin.progress);
  for (std::size_t i = 0; i < origin.arguments.size(); ++i)
    image.text(fmt::format("origin/arguments/{}", i), origin.arguments[i]);
  image.dataset<long long>(
      "origin/numbers", {format, (long long)origin.arguments.size(), (long long)origin.meshes}, {3});
  Saving saving(image);
  visit(saving);
  std::string bytes = image.bytes();
  bytes += tail_of(bytes);
  write_whole(bytes, file);
}

Checkpoint::Checkpoint(const std::string& file, bool any_program) : file_(file) {
  std::error_code none;
  std::ifstream in;
  if (std::filesystem::is_regular_file(file, none))
    in.open(file, std::ios::binary | std::ios::ate);  // a folder can be opened too, and a pipe would block
  if (!in.is_open() || !in)
    refuse(file,
           "no checkpoint can be read there; a run leaves one with --checkpoint, or when it is interrupted");
  bytes_.resize(std::size_t(std::max<std::streamoff>(0, in.tellg())));
  in.seekg(0);
  in.read(bytes_.data(), std::streamsize(bytes_.size()));
  const std::size_t tail = tail_of({}).size();
  const std::string_view all = bytes_;
  if (!in || all.size() < tail || all.substr(all.size() - tail) != tail_of(all.substr(0, all.size() - tail)))
    refuse(file, "the checkpoint is cut short or damaged: its checksum is not that of its bytes");
  bytes_.resize(bytes_.size() - tail);
  try {
    const hdf5::Opened opened(file, bytes_);
    std::array<long long, 3> numbers{};
    opened.read("origin/numbers", H5T_NATIVE_INT64, numbers.data(), numbers.size());
    if (numbers[0] != format)
      refuse(file, fmt::format("the checkpoint has format {}; expected {}: take the program that wrote it",
                               numbers[0], format));
    if (const std::string writer = opened.text("origin/program"); writer != program() && !any_program)
      refuse(file, fmt::format("the checkpoint was written by {}, and this is {}: results may differ; "
                               "--any-program goes on all the same",
                               writer, program()));
    origin_.scene_file = opened.text("origin/scene_file");
    origin_.scene_path = opened.text("origin/scene_path");
    origin_.scene_text = opened.text("origin/scene_text");
    origin_.progress = opened.text("origin/progress");
    for (long long i = 0; i < numbers[1]; ++i)
      origin_.arguments.push_back(opened.text(fmt::format("origin/arguments/{}", i)));
    origin_.meshes = std::uint64_t(numbers[2]);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    refuse(file, error.what());
  }
}

void Checkpoint::restore(const std::function<void(Archive&)>& visit) const {
  try {
    const hdf5::Opened opened(file_, bytes_);
    Restoring restoring(opened);
    visit(restoring);
  } catch (const std::runtime_error& error) {
    refuse(file_, error.what());
  }
}

}  // namespace femsph
