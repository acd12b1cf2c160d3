#pragma once
// Copies values between interleaved nodal vectors and the registers of a batch. `at` holds the offsets of one
// batch: [corner][lane].

#include "fem/mesh/gauss.hpp"

namespace femsph::fem {

using Pair = double __attribute__((vector_size(16)));

FEMSPH_INLINE Pair load_pair(const double* p) { return load_unaligned<Pair>(p); }

/// The first and the second values of eight pairs, by 16-byte loads and shuffles.
FEMSPH_INLINE void load_pairs(const double* v, const int* at, Pack& first, Pack& second) {
  const auto four = [&](int l) __attribute__((always_inline)) {
    const auto a = __builtin_shufflevector(load_pair(v + at[l]), load_pair(v + at[l + 1]), 0, 1, 2, 3);
    const auto b = __builtin_shufflevector(load_pair(v + at[l + 2]), load_pair(v + at[l + 3]), 0, 1, 2, 3);
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const Pack low = four(0), high = four(4);
  first = __builtin_shufflevector(low, high, 0, 2, 4, 6, 8, 10, 12, 14);
  second = __builtin_shufflevector(low, high, 1, 3, 5, 7, 9, 11, 13, 15);
}

/// x[corner * dim + component] of all eight cells (Pack; the lane is ignored), or of the cell in `lane`
/// (double).
template <int dim>
FEMSPH_INLINE void gather(const double* v, const int* at, int, Pack* x) {
#pragma GCC unroll 8
  for (int a = 0; a < corners<dim>; ++a) {
    const int* i = at + a * lanes;
    load_pairs(v, i, x[a * dim], x[a * dim + 1]);
    if constexpr (dim == 3) {
      const double* w = v + 2;
      x[a * dim + 2] = Pack{w[i[0]], w[i[1]], w[i[2]], w[i[3]], w[i[4]], w[i[5]], w[i[6]], w[i[7]]};
    }
  }
}
template <int dim>
FEMSPH_INLINE void gather(const double* v, const int* at, int lane, double* x) {
  for (int a = 0; a < corners<dim>; ++a)
    for (int c = 0; c < dim; ++c) x[a * dim + c] = v[at[a * lanes + lane] + c];
}

/// v += factor f, one lane after the other, since lanes may share nodes.
template <int dim>
FEMSPH_INLINE void scatter_add(const Pack* f, double factor, const int* at, int, double* v) {
#pragma GCC unroll 8
  for (int a = 0; a < corners<dim>; ++a) {
    const int* i = at + a * lanes;
    const Pack x = factor * f[a * dim], y = factor * f[a * dim + 1];
    alignas(64) double pairs[2 * lanes];
    store(pairs, __builtin_shufflevector(x, y, 0, 8, 1, 9, 2, 10, 3, 11));
    store(pairs + lanes, __builtin_shufflevector(x, y, 4, 12, 5, 13, 6, 14, 7, 15));
    [[maybe_unused]] Pack z{};
    if constexpr (dim == 3) z = factor * f[a * dim + 2];
#pragma GCC unroll 8
    for (int l = 0; l < lanes; ++l) {
      double* p = v + i[l];
      store_unaligned(p, load_pair(p) + load<Pair>(pairs + 2 * l));
      if constexpr (dim == 3) p[2] += z[l];
    }
  }
}
template <int dim>
FEMSPH_INLINE void scatter_add(const double* f, double factor, const int* at, int lane, double* v) {
  for (int a = 0; a < corners<dim>; ++a)
    for (int c = 0; c < dim; ++c) v[at[a * lanes + lane] + c] += factor * f[a * dim + c];
}

}  // namespace femsph::fem
