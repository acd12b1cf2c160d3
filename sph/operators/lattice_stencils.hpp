#pragma once
// Rows of a lattice. Eight consecutive particles, a block, share one list of slots (offset, w, lane mask),
// and blocks with equal lists share one descriptor. A few dozen descriptors describe a whole lattice, and
// neighbours are loaded contiguously.

#include <array>
#include <cstdint>
#include <vector>

#include "model/numerics/simd.hpp"
#include "model/numerics/tensor.hpp"
#include "sph/operators/rows.hpp"
#include "sph/operators/tensor_layout.hpp"

namespace femsph::sph {

/// One value in the lanes of `mask`, 0 in the others.
FEMSPH_INLINE Pack masked(unsigned mask, double x) {
  static constexpr auto table = [] {
    std::array<std::array<double, lanes>, 1u << lanes> t{};
    for (unsigned m = 0; m < (1u << lanes); ++m)
      for (int l = 0; l < lanes; ++l) t[m][std::size_t(l)] = m >> l & 1 ? 1.0 : 0.0;
    return t;
  }();
  return load_unaligned<Pack>(table[mask].data()) * x;
}

template <int dim>
class LatticeStencils {
 public:
  using Tensors = TensorRows<dim>;
  using OneValue = LatticeStencils<1>;  ///< the same particles with one value each
  LatticeStencils(const RowSource& rows, std::size_t particles);
  std::size_t blocks() const { return descriptor_of_.size(); }
  std::size_t bytes() const;
  std::size_t descriptors() const { return descriptors_.size(); }
  /// Largest |offset| between neighbours: how much padding a field needs at both ends.
  std::size_t reach() const { return reach_; }

  /// H = sum_j (u_j - u_i) (x) w_ij of the eight particles that start at `u` (component stride `stride`);
  /// with_scale adds L = sum_j scale_ij (u_j - u_i).
  template <bool with_scale>
  FEMSPH_INLINE void gradient(std::size_t block, const double* u, std::size_t stride, Tensor<Pack, dim>& H,
                              Pack (&L)[dim]) const {
    Pack here[dim];
    for (int r = 0; r < dim; ++r) {
      here[r] = load_unaligned<Pack>(u + r * stride);
      L[r] = Pack{};
      for (int c = 0; c < dim; ++c) H[r][c] = Pack{};
    }
    gradient_groups<with_scale, 1>(descriptors_[descriptor_of_[block]], u, stride, here, H, L);
  }

  /// sum_j Q_j w_ij; Q starts at `q`.
  FEMSPH_INLINE void divergence(std::size_t block, const double* q, std::size_t stride,
                                Pack (&f)[dim]) const {
    Pack part[dim][dim];
    for (auto& row : part)
      for (Pack& x : row) x = Pack{};
    divergence_groups<1>(descriptors_[descriptor_of_[block]], q, stride, part);
    for (int r = 0; r < dim; ++r) {
      f[r] = part[r][0];
      for (int c = 1; c < dim; ++c) f[r] += part[r][c];
    }
  }

  /// Calls take(difference[dim], w[dim], scale) for every neighbour; lanes without that neighbour have w = 0
  /// and scale = 0.
  template <class Take>
  FEMSPH_INLINE void each(std::size_t block, const double* u, std::size_t stride, Take&& take) const {
    Pack here[dim];
    for (int r = 0; r < dim; ++r) here[r] = load_unaligned<Pack>(u + r * stride);
    const Descriptor& d = descriptors_[descriptor_of_[block]];
    for (std::uint32_t k = d.begin[0]; k < d.begin[groups]; ++k) {
      const Slot& s = slots_[k];
      Pack difference[dim], w[dim];
      for (int r = 0; r < dim; ++r) {
        difference[r] = load_unaligned<Pack>(u + r * stride + s.offset) - here[r];
        w[r] = masked(s.mask, s.w[r]);
      }
      take(difference, w, masked(s.mask, s.scale));
    }
  }
  /// Calls take(j) for every neighbour of a block's particles; a neighbour of several comes several times.
  template <class Take>
  void each_index(std::size_t block, Take&& take) const {
    const Descriptor& d = descriptors_[descriptor_of_[block]];
    for (std::uint32_t k = d.begin[0]; k < d.begin[groups]; ++k)
      for (int l = 0; l < lanes; ++l)
        if (slots_[k].mask >> l & 1) take(std::size_t(std::ptrdiff_t(block * lanes) + l + slots_[k].offset));
  }

 private:
  struct Slot {
    double w[dim];
    double scale;
    std::int32_t offset;
    std::uint32_t mask;
  };
  // Slots are grouped by which components of w are not zero (pattern 1 .. 2^dim - 1) and whether all lanes
  // take part.
  static constexpr int patterns = 1 << dim, groups = 2 * patterns;
  static constexpr std::uint32_t all_lanes = (1u << lanes) - 1;
  struct Descriptor {
    std::uint32_t begin[groups + 1];
  };
  static int pattern_of(const Slot& s) {
    int p = 0;
    for (int a = 0; a < dim; ++a)
      if (s.w[a] != 0) p |= 1 << a;
    return p;
  }
  static int group_of(const Slot& s) { return 2 * pattern_of(s) + (s.mask != all_lanes); }
  std::vector<Slot> slots_of_block(const RowSource& rows, std::size_t block, std::size_t particles,
                                   Row& scratch) const;

  template <bool with_scale, int pattern>
  FEMSPH_INLINE void gradient_groups(const Descriptor& d, const double* u, std::size_t stride,
                                     const Pack (&here)[dim], Tensor<Pack, dim>& H, Pack (&L)[dim]) const {
    gradient_slots<with_scale, pattern, false>(
        d.begin[2 * pattern], d.begin[2 * pattern + 1], u, stride, here, H, L);
    gradient_slots<with_scale, pattern, true>(
        d.begin[2 * pattern + 1], d.begin[2 * pattern + 2], u, stride, here, H, L);
    if constexpr (pattern + 1 < patterns) gradient_groups<with_scale, pattern + 1>(d, u, stride, here, H, L);
  }
  template <bool with_scale, int pattern, bool partial>
  FEMSPH_INLINE void gradient_slots(std::uint32_t k, std::uint32_t end, const double* u, std::size_t stride,
                                    const Pack (&here)[dim], Tensor<Pack, dim>& H, Pack (&L)[dim]) const {
    for (; k < end; ++k) {
      const Slot& s = slots_[k];
      Pack difference[dim];
      for (int r = 0; r < dim; ++r) difference[r] = load_unaligned<Pack>(u + r * stride + s.offset) - here[r];
      for (int c = 0; c < dim; ++c)
        if (pattern >> c & 1) {
          const Pack w = partial ? masked(s.mask, s.w[c]) : broadcast<Pack>(s.w[c]);
          for (int r = 0; r < dim; ++r) H[r][c] += difference[r] * w;
        }
      if constexpr (with_scale) {
        const Pack w = partial ? masked(s.mask, s.scale) : broadcast<Pack>(s.scale);
        for (int r = 0; r < dim; ++r) L[r] += difference[r] * w;
      }
    }
  }
  template <int pattern>
  FEMSPH_INLINE void divergence_groups(const Descriptor& d, const double* q, std::size_t stride,
                                       Pack (&part)[dim][dim]) const {
    divergence_slots<pattern, false>(d.begin[2 * pattern], d.begin[2 * pattern + 1], q, stride, part);
    divergence_slots<pattern, true>(d.begin[2 * pattern + 1], d.begin[2 * pattern + 2], q, stride, part);
    if constexpr (pattern + 1 < patterns) divergence_groups<pattern + 1>(d, q, stride, part);
  }
  template <int pattern, bool partial>
  FEMSPH_INLINE void divergence_slots(std::uint32_t k, std::uint32_t end, const double* q, std::size_t stride,
                                      Pack (&part)[dim][dim]) const {
    for (; k < end; ++k) {
      const Slot& s = slots_[k];
      for (int c = 0; c < dim; ++c)
        if (pattern >> c & 1) {
          const Pack w = partial ? masked(s.mask, s.w[c]) : broadcast<Pack>(s.w[c]);
          for (int r = 0; r < dim; ++r)
            part[r][c] += load_unaligned<Pack>(q + (r * dim + c) * stride + s.offset) * w;
        }
    }
  }

  std::vector<Slot> slots_;
  std::vector<Descriptor> descriptors_;
  std::vector<std::uint32_t> descriptor_of_;
  std::size_t reach_ = 0;
};

extern template class LatticeStencils<1>;  // one value a particle: mean_dilatation.hpp
extern template class LatticeStencils<2>;
extern template class LatticeStencils<3>;

}  // namespace femsph::sph
