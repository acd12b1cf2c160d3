#pragma once
// Loops over the entries of flat vectors.

#include <algorithm>
#include <cstddef>

#include "model/numerics/parallel.hpp"

namespace femsph {

/// An entry takes at most a quarter of the time of a particle's forces. For fewer entries than this, starting
/// the threads costs more than it saves.
inline constexpr std::size_t entries_for_one_thread = 4 * serial_below;

/// parallel_sum over n entries, on one thread where there are few; the result is the same to the last bit.
template <class Body>
double sum_of_entries(std::size_t n, Body&& body) {
  if (n >= entries_for_one_thread) return parallel_sum(n, body);
  double sum = 0;
  for (std::size_t begin = 0; begin < n; begin += 4096) sum += body(begin, std::min(begin + 4096, n));
  return sum;
}

}  // namespace femsph
