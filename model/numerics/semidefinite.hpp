#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace femsph {

/// Solves A x = b for a symmetric positive semidefinite A (n x n, row by row) by Cholesky's factorization
/// with diagonal pivots (Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 10.3).
/// Elimination ends at the first pivot that is not above `least_pivot`: unknowns that A does not determine
/// are 0, and their equations are left out. The first `leading` unknowns are eliminated before the others, in
/// their order.
struct SemidefiniteSolution {
  std::vector<double> x;
  std::size_t rank = 0;  ///< number of unknowns that were solved for
};
SemidefiniteSolution solve_semidefinite(std::span<const double> A, std::span<const double> b,
                                        double least_pivot, std::size_t leading = 0);

}  // namespace femsph
