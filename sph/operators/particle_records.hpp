#pragma once
// The fields of a particle stored side by side, eight numbers in a cache line, for loops over neighbours that
// are anywhere in memory: eight lines are loaded and transposed, which costs a third of 64 single loads.

#include <cstdint>

#include "model/numerics/array.hpp"
#include "model/numerics/simd.hpp"

namespace femsph::sph {

/// rows[i][j] <-> rows[j][i]
FEMSPH_INLINE void transpose(Pack (&m)[lanes]) {
  static_assert(lanes == 8);
  Pack a[8], b[8];
  for (int i = 0; i < 8; i += 2) {
    a[i] = __builtin_shufflevector(m[i], m[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    a[i + 1] = __builtin_shufflevector(m[i], m[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int i = 0; i < 8; i += 4)
    for (int k = 0; k < 2; ++k) {
      b[i + k] = __builtin_shufflevector(a[i + k], a[i + k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      b[i + k + 2] = __builtin_shufflevector(a[i + k], a[i + k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (int k = 0; k < 4; ++k) {
    m[k] = __builtin_shufflevector(b[k], b[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    m[k + 4] = __builtin_shufflevector(b[k], b[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

/// `lines` cache lines a particle: 8 * lines fields.
template <int lines>
class ParticleRecords {
 public:
  static constexpr int fields = lanes * lines;
  void resize(std::size_t particles) {
    const std::size_t size = round_up(particles, lanes) * fields;
    if (data_.size() != size) data_.assign(size, 0.0);
  }
  std::size_t bytes() const { return data_.size() * sizeof(double); }

  /// Loads the fields of eight consecutive particles; gather() those of any eight.
  FEMSPH_INLINE void load_block(std::size_t block, Pack (&out)[fields]) const {
    each_line(
        [&](int line, int lane) __attribute__((always_inline)) {
          return &data_[(block * lanes + std::size_t(lane)) * fields + std::size_t(line) * lanes];
        },
        out);
  }
  FEMSPH_INLINE void gather(const std::int32_t* index, Pack (&out)[fields]) const {
    each_line(
        [&](int line, int lane) __attribute__((always_inline)) {
          return data_.data() + std::ptrdiff_t(index[lane]) * fields + line * lanes;
        },
        out);
  }
  /// The first eight fields alone.
  FEMSPH_INLINE void gather_first(const std::int32_t* index, Pack (&out)[lanes]) const {
    for (int l = 0; l < lanes; ++l) out[l] = load<Pack>(data_.data() + std::ptrdiff_t(index[l]) * fields);
    transpose(out);
  }
  FEMSPH_INLINE void load_first(std::size_t block, Pack (&out)[lanes]) const {
    for (int l = 0; l < lanes; ++l) out[l] = load<Pack>(&data_[(block * lanes + std::size_t(l)) * fields]);
    transpose(out);
  }
  /// Fields of particle `to` = those of `from` times `sign` plus `shift`.
  FEMSPH_INLINE void image(std::size_t to, std::size_t from, const Pack (&sign)[lines],
                           const Pack (&shift)[lines]) {
    for (int line = 0; line < lines; ++line)
      store(&data_[to * fields + std::size_t(line) * lanes],
            sign[line] * load<Pack>(&data_[from * fields + std::size_t(line) * lanes]) + shift[line]);
  }
  FEMSPH_INLINE void store_block(std::size_t block, const Pack (&fields_of)[fields]) {
    for (int line = 0; line < lines; ++line) {
      Pack m[lanes];
      for (int k = 0; k < lanes; ++k) m[k] = fields_of[line * lanes + k];
      transpose(m);
      for (int l = 0; l < lanes; ++l)
        store(&data_[(block * lanes + std::size_t(l)) * fields + std::size_t(line) * lanes], m[l]);
    }
  }

 private:
  template <class At>
  FEMSPH_INLINE static void each_line(At&& at, Pack (&out)[fields]) {
    for (int line = 0; line < lines; ++line) {
      Pack m[lanes];
      for (int l = 0; l < lanes; ++l) m[l] = load<Pack>(at(line, l));
      transpose(m);
      for (int k = 0; k < lanes; ++k) out[line * lanes + k] = m[k];
    }
  }
  AlignedVector<double> data_;
};

}  // namespace femsph::sph
