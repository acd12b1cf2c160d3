#pragma once
// Threads. One number of threads holds for all parallel loops of the program. Sums are cut into chunks whose
// bounds depend on the problem only, and the partial sums are added in the order of the chunks, so that
// results do not depend on the number of threads.

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace femsph {

/// The number of threads of parallel loops.
int threads();
void set_threads(int n);

/// Makes the calling thread treat numbers below 1e-307 as 0, as the threads of loops always do. Ahead of a
/// wave front such numbers are frequent, and operations on them take ten times as long.
void flush_denormals();

/// Runs task(0) .. task(n - 1) at the same time, one of them on the calling thread, and returns when all have
/// ended. The threads remain for the next call: they wait actively for some microseconds and then sleep. Must
/// not be called inside a task.
void run_on_threads(int n, const std::function<void(int)>& task);

/// A loop over fewer particles or cells than this runs on one thread.
inline constexpr std::size_t serial_below = 8192;

/// Calls body(begin, end) on ranges that cover [0, n) with bounds that are multiples of `grain`. An item
/// costs as much as `weight` particles or cells. The ranges may depend on the number of threads, so body must
/// treat each item independently.
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

/// The sums of what body(begin, end) returns (std::array<double, count>) over fixed chunks of [0, n), added
/// in the order of the chunks: the same to the last bit for any number of threads.
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
