#pragma once
// Threads. One number governs every parallel loop of the program. The work is cut into chunks whose
// borders depend on the problem only, and partial sums are added in chunk order: results never
// depend on how many threads ran.

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace femsph {

/// How many threads the parallel loops use.
int threads();
void set_threads(int n);

/// Lets the calling thread treat numbers below 1e-307 as 0 (the loops' own threads always do). The front of a
/// wave leaves such numbers behind it, and a processor takes ten times longer over each.
void flush_denormals();

/// Runs task(0) .. task(n - 1) at the same time, one of them on the calling thread, and returns when all are
/// done. The threads stay for the next call: they look out for it for some microseconds and then sleep, so
/// that a busy machine is not made busier. Not for use inside a task.
void run_on_threads(int n, const std::function<void(int)>& task);

/// Below this many particles or cells a loop is not worth a fork.
inline constexpr std::size_t serial_below = 8192;

/// Calls body(begin, end) on ranges that cover [0, n); the borders are multiples of `grain`. An item stands
/// for `weight` particles or cells. The ranges may depend on the thread count, so body must treat each item
/// on its own.
template <class Body>
void parallel_for(std::size_t n, std::size_t grain, Body&& body, std::size_t weight = 1) {
  const std::size_t t = n * weight < serial_below ? 1 : static_cast<std::size_t>(threads());
  if (t <= 1) {
    if (n > 0) body(std::size_t{0}, n);
    return;
  }
  const std::size_t grains = (n + grain - 1) / grain;
  run_on_threads(static_cast<int>(t), [&](int i) {
    const std::size_t begin = grains * static_cast<std::size_t>(i) / t * grain,
                      end = grains * (static_cast<std::size_t>(i) + 1) / t * grain;
    if (begin < n) body(begin, end < n ? end : n);
  });
}

/// Sums of what body(begin, end) returns (std::array<double, count>) over fixed chunks of [0, n), added in
/// chunk order: the same to the last bit for any thread count.
template <std::size_t count, class Body>
std::array<double, count> parallel_sums(std::size_t n, Body&& body) {
  using Sums = std::array<double, count>;
  constexpr std::size_t chunk = 4096;
  const std::size_t chunks = (n + chunk - 1) / chunk;
  if (chunks <= 1) return n > 0 ? body(std::size_t{0}, n) : Sums{};
  static thread_local std::vector<Sums> partial;
  partial.assign(chunks, Sums{});
  Sums* p = partial.data();
  parallel_for(n, chunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; b += chunk)
      p[b / chunk] = body(b, b + chunk < end ? b + chunk : end);
  });
  Sums sum{};
  for (std::size_t c = 0; c < chunks; ++c)
    for (std::size_t k = 0; k < count; ++k) sum[k] += p[c][k];
  return sum;
}

/// The same for one sum.
template <class Body>
double parallel_sum(std::size_t n, Body&& body) {
  return parallel_sums<1>(
      n, [&](std::size_t begin, std::size_t end) { return std::array{body(begin, end)}; })[0];
}

}  // namespace femsph
