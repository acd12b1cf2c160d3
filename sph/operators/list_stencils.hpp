#pragma once
// Rows of scattered particles: the k-th neighbours of eight particles are stored side by side (SELL-8) and
// gathered. The interface is that of lattice_stencils.hpp.

#include <cstdint>
#include <type_traits>
#include <vector>

#include "model/numerics/array.hpp"
#include "model/numerics/simd.hpp"
#include "model/numerics/tensor.hpp"
#include "sph/operators/rows.hpp"
#include "sph/operators/tensor_layout.hpp"

namespace femsph::sph {

template <int dim>
class ListStencils {
 public:
  using Tensors = std::conditional_t<dim == 3, TensorRecords, TensorRows<dim>>;
  using OneValue = ListStencils<1>;
  ListStencils(const RowSource& rows, std::size_t particles);
  std::size_t blocks() const { return begin_.size() - 1; }
  std::size_t bytes() const;
  std::size_t reach() const { return 0; }

  template <bool with_scale>
  FEMSPH_INLINE void gradient(std::size_t block, const double* u, std::size_t stride, Tensor<Pack, dim>& H,
                              Pack (&L)[dim]) const {
    for (int r = 0; r < dim; ++r) {
      L[r] = Pack{};
      for (int c = 0; c < dim; ++c) H[r][c] = Pack{};
    }
    each(
        block, u, stride,
        [&](const Pack(&difference)[dim], const Pack(&w)[dim], const Pack& scale)
            __attribute__((always_inline)) {
              for (int r = 0; r < dim; ++r) {
                for (int c = 0; c < dim; ++c) H[r][c] += difference[r] * w[c];
                if constexpr (with_scale) L[r] += difference[r] * scale;
              }
            });
  }
  FEMSPH_INLINE void divergence(std::size_t block, const double* q, std::size_t stride,
                                Pack (&f)[dim]) const {
    for (Pack& x : f) x = Pack{};
    const double* origin = q - Tensors::at(block * lanes, 0, stride);
    for (std::size_t k = begin_[block]; k < begin_[block + 1]; ++k) {
      Pack Q[dim * dim];
      if constexpr (dim == 3)
        Tensors::gather(origin, &index_[k * lanes], Q);
      else
        for (int n = 0; n < dim * dim; ++n)
          Q[n] = gather(origin + std::size_t(n) * stride, &index_[k * lanes]);
      for (int c = 0; c < dim; ++c) {
        const Pack w = load<Pack>(&weight_[(k * (dim + 1) + c) * lanes]);
        for (int r = 0; r < dim; ++r) f[r] += Q[r * dim + c] * w;
      }
    }
  }
  template <class Take>
  FEMSPH_INLINE void each(std::size_t block, const double* u, std::size_t stride, Take&& take) const {
    const double* origin = u - block * lanes;  // of particle 0
    Pack here[dim];
    for (int r = 0; r < dim; ++r) here[r] = load_unaligned<Pack>(u + r * stride);
    for (std::size_t k = begin_[block]; k < begin_[block + 1]; ++k) {
      Pack difference[dim], w[dim];
      for (int r = 0; r < dim; ++r) {
        difference[r] = gather(origin + r * stride, &index_[k * lanes]) - here[r];
        w[r] = load<Pack>(&weight_[(k * (dim + 1) + r) * lanes]);
      }
      take(difference, w, load<Pack>(&weight_[(k * (dim + 1) + dim) * lanes]));
    }
  }
  template <class Take>
  void each_index(std::size_t block, Take&& take) const {
    for (std::size_t k = begin_[block] * lanes; k < begin_[block + 1] * lanes; ++k)
      take(std::size_t(index_[k]));
  }
  /// sum_j scale_ij |H x_ij - u_ij|^2 of projected rows. Their stored scale is a symmetric mean
  /// (projection.hpp), so scale_ij is found from w_ij = scale_ij x_ij.
  Pack misfit(std::size_t block, const std::vector<Point>& position, const double* u, std::size_t stride,
              const Tensor<Pack, dim>& H) const {
    Pack sum{};
    std::size_t k = begin_[block];
    each(block, u, stride, [&](const Pack(&difference)[dim], const Pack(&w)[dim], const Pack&) {
      for (int l = 0; l < lanes; ++l) {
        const Point &to = position[std::size_t(index_[k * lanes + std::size_t(l)])],
                    &from = position[std::min(block * lanes + std::size_t(l), position.size() - 1)];
        double along = 0, far = 0, square = 0;
        for (int r = 0; r < dim; ++r) {
          double off = -difference[r][l];
          for (int c = 0; c < dim; ++c) off += H[r][c][l] * (to[c] - from[c]);
          square += off * off;
          along += w[r][l] * (to[r] - from[r]), far += (to[r] - from[r]) * (to[r] - from[r]);
        }
        if (far > 0) sum[l] += along / far * square;
      }
      ++k;
    });
    return sum;
  }

 private:
  FEMSPH_INLINE static Pack gather(const double* p, const std::int32_t* index) {
    return Pack{p[index[0]], p[index[1]], p[index[2]], p[index[3]],
                p[index[4]], p[index[5]], p[index[6]], p[index[7]]};
  }
  std::vector<std::size_t> begin_;     ///< of each block, in neighbour groups
  AlignedVector<std::int32_t> index_;  ///< [group][lane]
  AlignedVector<double> weight_;       ///< [group][w.., scale][lane]
};

extern template class ListStencils<1>;  // one value a particle: mean_dilatation.hpp
extern template class ListStencils<2>;
extern template class ListStencils<3>;

}  // namespace femsph::sph
