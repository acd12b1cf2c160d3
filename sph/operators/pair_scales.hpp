#pragma once
// The unknowns of the projection (projection.hpp), one scale for each ordered pair of particles, and the area
// vectors A_i as functions of them. The pairs are stored in one array, row by row, and each pair (i, j) knows
// its reverse: the pair (j, i), or that of the particle whose mirror image j is.

#include <array>
#include <vector>

#include "sph/operators/rows.hpp"

namespace femsph::sph {

template <int dim>
class PairScales {
 public:
  using Vector = std::array<double, dim>;
  using Vectors = std::vector<Vector>;

  PairScales(const Particles& particles, const RowSource& rows, const std::vector<double>& volume);

  std::size_t size() const { return n_; }  ///< particles
  std::size_t pairs() const { return index_.size(); }
  bool complete() const { return complete_; }  ///< every pair has a reverse
  std::vector<double>& scale() { return scale_; }

  /// B and B x of the scales as they are now; false if some B does not exist.
  bool refresh();
  /// A_i.
  void area(Vectors& out);
  /// dA = J W J^T lambda: to first order, the change of A by changes W J^T lambda of the scales. J is the
  /// derivative of A by the scales, W = diag(the kernel's own scales).
  void apply(const Vectors& lambda, Vectors& out);
  /// scale += factor W J^T lambda.
  void add(const Vectors& lambda, double factor, std::vector<double>& scale);
  /// The diagonal of J W J^T, without the part of J that the change of B brings.
  void diagonal(Vectors& out) const;
  /// Sum of part_i u_i . v_i: in proportion to the sum over the body with its images.
  double product(const Vectors& u, const Vectors& v) const;

  std::vector<Row> rows() const;
  std::vector<Row> adjoint() const;

 private:
  static Vector times(double factor, Vector v) {
    for (double& x : v) x *= factor;
    return v;
  }
  double kernel_share(std::size_t i, std::size_t k) const {
    return p_.kernel_volume[std::size_t(index_[k])] / p_.kernel_volume[i];
  }
  const Vectors& with_images(const Vectors& own);
  void find_pairs_that_look_back();
  bool invert(std::size_t i);
  template <class Take>
  void changes(std::size_t i, const Vectors& lambda, Vectors& difference, Take&& take);
  void gather(Vectors& out) const;
  Neighbour neighbour(std::size_t k, double factor, double scale) const;
  template <class Make>
  std::vector<Row> made(Make&& make) const;

  const Particles& p_;
  std::size_t n_;
  const std::vector<double>& volume_;
  std::vector<std::size_t> begin_, back_;  ///< first pair of each row; the reverse of each pair
  std::vector<int> index_;                 ///< j
  std::vector<double> start_, scale_;      ///< the scale of the kernel; the present scale
  std::vector<Vector> x_, b_;              ///< x_ij = x_j - x_i; B_i x_ij
  std::vector<Vector> change_, all_;       ///< buffers of apply()
  bool complete_ = true;
};

}  // namespace femsph::sph
