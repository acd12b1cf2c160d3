#include "model/numerics/semidefinite.hpp"

#include <Eigen/Core>

namespace femsph {

namespace {

/// Eigen's LDLT chooses its pivots from the original diagonal of A, not from the remaining one, and therefore
/// does not find the rank.
template <int most>
SemidefiniteSolution solve(std::span<const double> values, std::span<const double> right, double least_pivot,
                           std::size_t leading) {
  using Eigen::Index;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, most, most>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most, 1>;
  using Order = Eigen::Matrix<Index, Eigen::Dynamic, 1, Eigen::ColMajor, most, 1>;
  const Index n = Index(right.size());
  Matrix A = Eigen::Map<const Matrix>(values.data(), n, n);
  Vector b = Eigen::Map<const Vector>(right.data(), n);
  Order order = Order::LinSpaced(n, 0, n - 1);
  Index rank = 0;
  for (; rank < n; ++rank) {
    Index pivot = 0;
    if (rank >= Index(leading)) A.diagonal().tail(n - rank).maxCoeff(&pivot);
    pivot += rank;
    if (!(A(pivot, pivot) > least_pivot)) break;
    A.row(rank).swap(A.row(pivot));
    A.col(rank).swap(A.col(pivot));
    std::swap(b[rank], b[pivot]);
    std::swap(order[rank], order[pivot]);
    const Index rest = n - rank - 1;
    const Vector factor = A.col(rank).tail(rest) / A(rank, rank);
    A.bottomRightCorner(rest, rest).noalias() -= factor * A.row(rank).tail(rest);
    b.tail(rest) -= b[rank] * factor;
  }
  const Vector y = A.topLeftCorner(rank, rank).template triangularView<Eigen::Upper>().solve(b.head(rank));
  SemidefiniteSolution out{std::vector<double>(std::size_t(n), 0.0), std::size_t(rank)};
  for (Index k = 0; k < rank; ++k) out.x[std::size_t(order[k])] = y[k];
  return out;
}

}  // namespace

SemidefiniteSolution solve_semidefinite(std::span<const double> A, std::span<const double> b,
                                        double least_pivot, std::size_t leading) {
  constexpr int small = 10;  // systems up to this size need no allocation
  return b.size() <= std::size_t(small) ? solve<small>(A, b, least_pivot, leading)
                                        : solve<Eigen::Dynamic>(A, b, least_pivot, leading);
}

}  // namespace femsph
