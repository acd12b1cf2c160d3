// Symmetric positive semidefinite systems: solved where they are regular, and without the unknowns that they
// do not determine. And the grid that finds points in a box.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/numerics/point_grid.hpp"
#include "model/numerics/semidefinite.hpp"

namespace femsph {
namespace {

/// A = sum of q q^T over `rank` random vectors of n components.
std::vector<double> gram_matrix(std::size_t n, std::size_t rank, std::mt19937& any) {
  std::uniform_real_distribution<double> pick(-1, 1);
  std::vector<double> A(n * n, 0.0);
  for (std::size_t k = 0; k < rank; ++k) {
    std::vector<double> q(n);
    for (double& x : q) x = pick(any);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) A[i * n + j] += q[i] * q[j];
  }
  return A;
}

std::vector<double> times(const std::vector<double>& A, const std::vector<double>& x) {
  std::vector<double> b(x.size(), 0.0);
  for (std::size_t i = 0; i < b.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) b[i] += A[i * b.size() + j] * x[j];
  return b;
}

// A right-hand side in the range of A is met, with as many unknowns as A has rank and 0 for the others.
TEST(Semidefinite, MeetsARightHandSideInTheRange) {
  std::mt19937 any(11);
  for (const std::size_t n : {1u, 3u, 10u, 17u})
    for (std::size_t rank = 1; rank <= n; rank += 2) {
      const std::vector<double> A = gram_matrix(n, rank, any), b = times(A, std::vector<double>(n, 1.0));
      const SemidefiniteSolution s = solve_semidefinite(A, b, 1e-10);
      EXPECT_EQ(s.rank, rank);
      EXPECT_EQ(std::count(s.x.begin(), s.x.end(), 0.0), std::ptrdiff_t(n - rank));
      const std::vector<double> met = times(A, s.x);
      for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(met[i], b[i], 1e-10) << n << " " << rank;
    }
}

// The columns 0 and 1 are parallel: the one with the larger pivot stays, unless the other comes first.
TEST(Semidefinite, LeadingUnknownsComeFirst) {
  const std::vector<double> A{1, 2, 0, 2, 4, 0, 0, 0, 3}, b{1, 0, 6};
  const SemidefiniteSolution free = solve_semidefinite(A, b, 1e-12), led = solve_semidefinite(A, b, 1e-12, 1);
  EXPECT_EQ(free.rank, 2u);
  EXPECT_EQ(free.x, (std::vector<double>{0, 0, 2}));
  EXPECT_EQ(led.rank, 2u);
  EXPECT_EQ(led.x, (std::vector<double>{1, 0, 2}));
  EXPECT_EQ(solve_semidefinite(std::vector<double>(4, 0.0), std::vector<double>(2, 1.0), 0).rank, 0u);
}

TEST(PointGrid, HoldsEveryPointOfABox) {
  std::mt19937 any(3);
  std::uniform_real_distribution<double> pick(0, 1);
  for (const int dim : {2, 3}) {
    std::vector<Point> points(500);
    for (Point& x : points) x = {pick(any), 3 * pick(any), dim == 3 ? pick(any) : 0.0};
    const PointGrid grid(points, dim, {0.1, 0.2, 0.1});
    for (int k = 0; k < 20; ++k) {
      const Point lower{pick(any), pick(any), -0.1}, upper{lower[0] + 0.2, lower[1] + 0.3, 0.6};
      const std::vector<std::size_t> found = grid.within(lower, upper);
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
      EXPECT_LT(found.size(), points.size() / 2);
      for (std::size_t i = 0; i < points.size(); ++i) {
        bool in = true;
        for (std::size_t a = 0; a < 3; ++a) in = in && points[i][a] >= lower[a] && points[i][a] <= upper[a];
        EXPECT_LE(in ? 1 : 0, std::count(found.begin(), found.end(), i));
      }
    }
  }
  EXPECT_TRUE(PointGrid().within({}, {}).empty());
}

}  // namespace
}  // namespace femsph
