// The rotation of the polar decomposition against its definition.

#include <gtest/gtest.h>

#include <random>

#include "model/material/kinematics.hpp"

namespace femsph::test {
namespace {

using Matrix = Tensor<double, 3>;

Matrix product(const Matrix& A, const Matrix& B) {
  Matrix C{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) C[i][j] += A[i][k] * B[k][j];
  return C;
}

/// A rotation by up to half a turn about a random axis (Rodrigues).
Matrix random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> angle(-3.14, 3.14);
  double n[3] = {normal(random), normal(random), normal(random)};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), a = angle(random);
  for (double& x : n) x /= length;
  const Matrix K{{{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}}}, K2 = product(K, K);
  Matrix R{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R[i][j] = (i == j) + std::sin(a) * K[i][j] + (1 - std::cos(a)) * K2[i][j];
  return R;
}

/// R diag(stretches) along random axes, all stretches within exp(+-size).
Matrix random_motion(std::mt19937& random, double size, Matrix& R) {
  std::uniform_real_distribution<double> value(-size, size);
  const Matrix Q = random_rotation(random);
  const double s[3] = {std::exp(value(random)), std::exp(value(random)), std::exp(value(random))};
  Matrix U{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) U[i][j] += Q[i][k] * s[k] * Q[j][k];
  R = random_rotation(random);
  return product(R, U);
}

// Stretches from 1 + 1e-8 to 4 and 1/4. U is found before R; the error is that of a few products of the size
// of R.
TEST(PolarRotation, IsTheRotationThatWasPutIn) {
  std::mt19937 random(7);
  for (const double size : {1e-8, 1e-3, 0.01, 0.02, 0.1, 0.15, 0.3, 0.7, 1.38})
    for (int turn = 0; turn < 500; ++turn) {
      Matrix R;
      const Matrix F = random_motion(random, size, R), found = polar_rotation<double, 3>(F);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) ASSERT_NEAR(found[i][j], R[i][j], 5e-15) << "stretch exp(" << size << ")";
    }
}

// Iterations end when every lane has converged: a lane beside strongly stretched ones gives what it gives
// alone, to round-off.
TEST(PolarRotation, LanesDoNotDisturbEachOther) {
  std::mt19937 random(8);
  const double sizes[lanes] = {1e-9, 1e-4, 0.01, 0.05, 0.2, 0.5, 1, 0};
  for (int turn = 0; turn < 200; ++turn) {
    Tensor<Pack, 3> F;
    Matrix alone[lanes];
    for (int l = 0; l < lanes; ++l) {
      Matrix R;
      const Matrix one = random_motion(random, sizes[l], R);
      alone[l] = polar_rotation<double, 3>(one);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) F[i][j][l] = one[i][j];
    }
    const Tensor<Pack, 3> together = polar_rotation<Pack, 3>(F);
    for (int l = 0; l < lanes; ++l)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) ASSERT_NEAR(together[i][j][l], alone[l][i][j], 2e-15);
  }
}

// All that the decomposition gives at once: R orthogonal, F = R U, U U^-1 = 1, by the short series, the long
// one, or iterations before it.
TEST(PolarRotation, StretchAndItsInverseGoWithIt) {
  std::mt19937 random(9);
  for (const double size :
       {0.0, 1e-8, 1e-4, 3.9e-4, 4.1e-4, 3e-3, 0.01, 0.018, 0.02, 0.05, 0.2, 0.24, 0.26, 0.7, 2.3})
    for (int turn = 0; turn < 300; ++turn) {
      Matrix put_in;
      const Matrix F = random_motion(random, size, put_in);
      Polar<double> p;
      polar(F, p);
      const double large = std::exp(size), round_off = 2e-15 * large * large;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          double RR = 0, RU = p.R[i][j], UU = (i == j) + p.strain(i, j) + p.shrink(i, j);
          for (int k = 0; k < 3; ++k) {
            RR += p.R[k][i] * p.R[k][j];
            RU += p.R[i][k] * p.strain(k, j);
            UU += p.strain(i, k) * p.shrink(k, j);
          }
          ASSERT_NEAR(RR, i == j, 4e-15) << "stretch exp(" << size << ")";
          ASSERT_NEAR(RU, F[i][j], round_off) << "stretch exp(" << size << ")";
          ASSERT_NEAR(UU, i == j, round_off) << "stretch exp(" << size << ")";
        }
    }
}

}  // namespace
}  // namespace femsph::test
