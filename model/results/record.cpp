#include "model/results/record.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <thread>

#include "femsph_provenance.hpp"
#include "model/results/whole_file.hpp"

namespace femsph {

namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

std::string compiler() {
#if defined(__clang__)
  return __VERSION__;
#else
  return "GCC " __VERSION__;
#endif
}

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (const auto colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
      return line.substr(colon + 2);
  return "unknown";
}

Pairs& registered() {
  static Pairs pairs;
  return pairs;
}

void set(Pairs& pairs, std::string key, std::string value) {
  const auto known = std::find_if(pairs.begin(), pairs.end(), [&](const auto& p) { return p.first == key; });
  if (known != pairs.end())
    known->second = std::move(value);
  else
    pairs.emplace_back(std::move(key), std::move(value));
}

toml::table table(const Pairs& pairs) {
  toml::table t;
  for (const auto& [key, value] : pairs) t.insert_or_assign(key, value);
  return t;
}

// clang-format off
toml::table energies(const Ledger& e) {
  return toml::table{{"kinetic", e.kinetic}, {"strain", e.strain}, {"hourglass", e.hourglass}, {"external", e.external},
                     {"damping", e.damping}, {"viscosity", e.viscosity}, {"initial", e.initial}, {"plastic", e.plastic},
                     {"contact", e.contact}, {"friction", e.friction}, {"imbalance", e.imbalance()}};
}

toml::table price(const Price& p) {
  toml::table phases;
  for (const auto& [phase, seconds] : p.phases) phases.insert_or_assign(phase, seconds);
  return toml::table{{"steps", p.steps}, {"dt", p.dt}, {"cpu", p.cpu}, {"wall", p.wall}, {"total_cpu", p.total_cpu}, {"threads", p.threads},
                     {"units", std::int64_t(p.units)}, {"bytes", std::int64_t(p.bytes)}, {"peak_memory", std::int64_t(peak_memory())},
                     {"nanoseconds_per_unit_step", p.nanoseconds()}, {"phases", std::move(phases)}};
}
// clang-format on

}  // namespace

Pairs provenance() {
  Pairs all{{"femsph", FEMSPH_VERSION},
            {"git", FEMSPH_GIT},
            {"compiler", compiler()},
            {"build_type", FEMSPH_BUILD_TYPE},
            {"flags", FEMSPH_FLAGS},
            {"HDF5", hdf5_version()},
            {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
            {"toml++", fmt::format("{}.{}.{}", TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)},
            {"processor", processor()},
            {"cores", std::to_string(std::thread::hardware_concurrency())}};
  for (const auto& [key, value] : registered()) set(all, key, value);
  return all;
}

void add_provenance(std::string key, std::string value) {
  set(registered(), std::move(key), std::move(value));
}

std::string version_line() {
  std::string git = FEMSPH_GIT;
  if (git == "unknown") return "femsph " FEMSPH_VERSION;
  const std::string mark = "-dirty";
  if (git.ends_with(mark)) git.replace(git.size() - mark.size(), mark.size(), ", modified");
  return fmt::format("femsph {} (git {})", FEMSPH_VERSION, git);
}

void write_record(const RunRecord& record, const std::string& folder) {
  toml::array warnings;
  for (const std::string& text : record.warnings) warnings.push_back(text);
  const toml::table document{
      {"warnings", warnings},
      {"scene_file", record.scene_file},
      {"method", record.method},
      {"command", record.command},
      {"outcome", record.outcome},
      {"finished_at", record.finished_at},
      {"derived", table(record.derived)},
      {"energy", energies(record.ledger)},
      {"price", price(record.price)},
      {"provenance", table(provenance())}};
  std::ostringstream out;
  out << "# One run of " << version_line()
      << ". SI units: energies in J, times in s, memory in bytes. The scene is in scene.toml.\n"
      << document << '\n';
  make_folder(folder);
  write_whole(record.scene_text, folder + "/scene.toml");
  write_whole(out.str(), folder + "/record.toml");
}

}  // namespace femsph
