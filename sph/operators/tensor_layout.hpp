#pragma once
// Where component k = r dim + c of a tensor field Q is stored for particle i: one row per component
// (TensorRows), or all components of a particle side by side (TensorRecords), which is faster where
// neighbours are anywhere in memory.

#include <cstddef>
#include <cstdint>

#include "model/numerics/simd.hpp"
#include "sph/operators/particle_records.hpp"

namespace femsph::sph {

template <int dim>
struct TensorRows {
  static constexpr int size = dim * dim;
  static std::size_t at(std::size_t i, int k, std::size_t stride) { return i + std::size_t(k) * stride; }
  /// Of the eight particles that start at q.
  FEMSPH_INLINE static void store(double* q, std::size_t stride, const Pack (&Q)[size]) {
    for (int k = 0; k < size; ++k) femsph::store(q + std::size_t(k) * stride, Q[k]);
  }
  FEMSPH_INLINE static void load(const double* q, std::size_t stride, Pack (&Q)[size]) {
    for (int k = 0; k < size; ++k) Q[k] = femsph::load<Pack>(q + std::size_t(k) * stride);
  }
};

/// The components of a particle side by side. In 3D eight neighbours take eight vector loads, a transpose and
/// eight loads of the ninth component, instead of 72 loads.
struct TensorRecords {
  static constexpr int size = 9;
  static std::size_t at(std::size_t i, int k, std::size_t) { return i * size + std::size_t(k); }
  FEMSPH_INLINE static void store(double* q, std::size_t, const Pack (&Q)[size]) {
    Pack m[lanes];
    for (int k = 0; k < lanes; ++k) m[k] = Q[k];
    transpose(m);
    for (int l = 0; l < lanes; ++l) {
      store_unaligned(q + l * size, m[l]);
      q[l * size + 8] = Q[8][l];
    }
  }
  FEMSPH_INLINE static void load(const double* q, std::size_t, Pack (&Q)[size]) {
    static constexpr std::int32_t next[lanes] = {0, 1, 2, 3, 4, 5, 6, 7};
    gather(q, next, Q);
  }
  FEMSPH_INLINE static void gather(const double* q, const std::int32_t* index, Pack (&Q)[size]) {
    Pack m[lanes];
    Pack last{};
    for (int l = 0; l < lanes; ++l) {
      const double* record = q + std::ptrdiff_t(index[l]) * size;
      m[l] = load_unaligned<Pack>(record);
      last[l] = record[8];
    }
    transpose(m);
    for (int k = 0; k < lanes; ++k) Q[k] = m[k];
    Q[8] = last;
  }
};

}  // namespace femsph::sph
