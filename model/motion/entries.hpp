#pragma once
// Loops over the entries of the flat vectors of a march.

#include <algorithm>
#include <cstddef>

#include "model/numerics/parallel.hpp"

namespace femsph {

/// Entries of a vector cost a quarter of a particle or less: below this many a loop over them is not worth a
/// fork.
inline constexpr std::size_t entries_for_one_thread = 4 * serial_below;

/// parallel_sum over the entries of a vector, to the same bits.
template <class Body>
double sum_of_entries(std::size_t n, Body&& body) {
  if (n >= entries_for_one_thread) return parallel_sum(n, body);
  double sum = 0;
  for (std::size_t begin = 0; begin < n; begin += 4096) sum += body(begin, std::min(begin + 4096, n));
  return sum;
}

}  // namespace femsph
