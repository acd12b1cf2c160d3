#pragma once
// Aligned arrays for the structure-of-arrays data of both solvers.

#include <cstddef>
#include <new>
#include <vector>

namespace femsph {

/// Allocates on 64-byte boundaries: a cache line, and the width of a Pack. Large blocks use huge pages where
/// the system has them: the state of a plastic body takes about a thousand bytes for each cell, and hardware
/// prefetching stops at the end of a page.
void* allocate_aligned(std::size_t bytes);
void release_aligned(void* p, std::size_t bytes);

template <class T>
struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(allocate_aligned(n * sizeof(T))); }
  void deallocate(T* p, std::size_t n) { release_aligned(p, n * sizeof(T)); }
  template <class U>
  bool operator==(const AlignedAllocator<U>&) const {
    return true;
  }
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

/// Smallest multiple of `step` that is not below n.
constexpr std::size_t round_up(std::size_t n, std::size_t step) { return (n + step - 1) / step * step; }

}  // namespace femsph
