#pragma once
// A pack of eight doubles, and the same functions for one double, so that a kernel written as template <class
// T> runs as SIMD code with T = Pack and as its own scalar reference with T = double. The compiler maps the
// eight lanes to the vector registers of the target (2 x 4 on AVX2, 4 x 2 on SSE2).

#include <cmath>
#include <cstddef>

namespace femsph {

inline constexpr int lanes = 8;

using Pack = double __attribute__((vector_size(lanes * sizeof(double))));
using PackMask = long __attribute__((vector_size(lanes * sizeof(long))));

#ifdef __OPTIMIZE__
#define FEMSPH_INLINE inline __attribute__((always_inline))
#else
#define FEMSPH_INLINE inline  // builds for sanitizers: half the compiler's time
#endif

/// T with every lane equal to x.
template <class T>
FEMSPH_INLINE T broadcast(double x) {
  return T{} + x;
}
template <>
FEMSPH_INLINE double broadcast<double>(double x) {
  return x;
}

/// Load from an address aligned to the size of T.
template <class T>
FEMSPH_INLINE T load(const double* p) {
  return *reinterpret_cast<const T*>(p);
}

/// Load from, and store to, any address that a double may have. Clang 14 reads through a vector type of lower
/// alignment as if it were aligned; GCC 12 copies 16 bytes by way of two integers (FEM: 32 instructions a
/// cell more).
template <class T>
FEMSPH_INLINE T load_unaligned(const double* p) {
#ifdef __clang__
  T x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
#else
  typedef T Unaligned __attribute__((aligned(alignof(double)), may_alias));
  return *reinterpret_cast<const Unaligned*>(p);
#endif
}
template <class T>
FEMSPH_INLINE void store_unaligned(double* p, T x) {
#ifdef __clang__
  __builtin_memcpy(p, &x, sizeof x);
#else
  typedef T Unaligned __attribute__((aligned(alignof(double)), may_alias));
  *reinterpret_cast<Unaligned*>(p) = x;
#endif
}

/// Store to an address aligned to the size of T.
template <class T>
FEMSPH_INLINE void store(double* p, T x) {
  *reinterpret_cast<T*>(p) = x;
}

/// Lane-wise mask ? a : b.
FEMSPH_INLINE Pack select(PackMask mask, Pack a, Pack b) { return mask ? a : b; }
FEMSPH_INLINE double select(bool mask, double a, double b) { return mask ? a : b; }

FEMSPH_INLINE double square_root(double x) { return std::sqrt(x); }
FEMSPH_INLINE Pack square_root(Pack x) {
  Pack y;
  for (int l = 0; l < lanes; ++l) y[l] = std::sqrt(x[l]);  // one vsqrtpd under -fno-math-errno
  return y;
}

/// True when the condition holds in any lane.
FEMSPH_INLINE bool any(bool mask) { return mask; }
FEMSPH_INLINE bool any(PackMask mask) {
#ifdef __AVX512DQ__
  // _mm512_movepi64_mask, the comparison's own mask; GCC would take the lanes one by one. Not by its name:
  // <immintrin.h> takes as long to compile as many a source.
  using Lanes = long long __attribute__((vector_size(lanes * sizeof(long long))));
  return __builtin_ia32_cvtq2mask512(reinterpret_cast<Lanes>(mask)) != 0;
#else
  using Half = long __attribute__((vector_size(4 * sizeof(long))));
  using Quarter = long __attribute__((vector_size(2 * sizeof(long))));
  const Half h = __builtin_shufflevector(mask, mask, 0, 1, 2, 3) |
                 __builtin_shufflevector(mask, mask, 4, 5, 6, 7);
  const Quarter q = __builtin_shufflevector(h, h, 0, 1) | __builtin_shufflevector(h, h, 2, 3);
  return (q[0] | q[1]) != 0;
#endif
}

/// Sum over the lanes, in lane order.
FEMSPH_INLINE double horizontal_sum(double x) { return x; }
FEMSPH_INLINE double horizontal_sum(Pack x) {
  double s = 0;
  for (int l = 0; l < lanes; ++l) s += x[l];
  return s;
}

/// How many lanes a scalar type has.
template <class T>
inline constexpr int lanes_of = static_cast<int>(sizeof(T) / sizeof(double));

}  // namespace femsph
