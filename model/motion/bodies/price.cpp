#include "model/motion/bodies/price.hpp"

#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <fstream>

namespace femsph {

namespace {

double seconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

}  // namespace

double cpu_seconds() { return seconds(CLOCK_PROCESS_CPUTIME_ID); }
double wall_seconds() { return seconds(CLOCK_MONOTONIC); }

/// From VmHWM rather than getrusage(): the maximum of the latter survives exec() and may be that of the
/// calling script.
std::size_t peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string key; status >> key; status.ignore(1 << 12, '\n')) {
    std::size_t kilobytes = 0;
    if (key == "VmHWM:" && status >> kilobytes) return kilobytes * 1024;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::size_t(usage.ru_maxrss) * 1024;
}

void Price::add(const std::string& phase, double seconds) {
  const auto found = std::find_if(
      phases.begin(), phases.end(), [&](const auto& p) { return p.first == phase; });
  if (found != phases.end())
    found->second += seconds;
  else
    phases.emplace_back(phase, seconds);
}

}  // namespace femsph
