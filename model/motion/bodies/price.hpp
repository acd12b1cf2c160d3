#pragma once
// The cost of a run: CPU time, wall time and memory.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace femsph {

/// CPU seconds of this process so far, all threads together; and seconds of a clock from an arbitrary origin.
double cpu_seconds();
double wall_seconds();
/// Largest resident set of this process so far, bytes.
std::size_t peak_memory();

struct Price {
  long steps = 0;
  double dt = 0;             ///< s
  double cpu = 0, wall = 0;  ///< s, of the time integration
  double total_cpu = 0;      ///< s, of the whole run: set-up, critical step, time integration, output
  int threads = 1;
  std::size_t units = 0;  ///< particles or elements
  std::size_t bytes = 0;  ///< memory of the discretizations and of the time integration
  std::vector<std::pair<std::string, double>>
      phases;  ///< wall seconds per phase: setup, critical step, march, output
  void add(const std::string& phase, double seconds);
  /// CPU nanoseconds per particle- or element-step.
  double nanoseconds() const { return steps && units ? 1e9 * cpu / (double(steps) * double(units)) : 0.0; }
};

/// Adds the wall time of a scope to a phase.
class PhaseTimer {
 public:
  PhaseTimer(Price& price, std::string phase)
      : price_(price), phase_(std::move(phase)), start_(wall_seconds()) {}
  ~PhaseTimer() { price_.add(phase_, wall_seconds() - start_); }
  PhaseTimer(const PhaseTimer&) = delete;

 private:
  Price& price_;
  std::string phase_;
  double start_;
};

}  // namespace femsph
