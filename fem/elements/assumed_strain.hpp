#pragma once
// Assumed strain fields of Belytschko and Bindeman, without shear or volumetric locking and without a
// parameter:
//   2D "ASQBI", Comput. Meth. Appl. Mech. Engng 88 (1991) 311-340; 3D, ibid. 105 (1993) 225-260.
// strain = mean strain + sum over hourglass modes a of their gradients h_a,j times q_a = gamma_a . u, in the
// cell's own axes:
//   row i of the normal strains takes from u_j   h_a,j q_aj w(a, i, j),
//     w = 1 (i = j);  -nubar (a = k, the third axis);  -nu (a = j or a = 4);  0 (a = i);      2D: w = 1 or
//     -nubar
//   2 e_ij takes  h_a,j q_ai + h_a,i q_aj  from a = i and a = j (the twists);                 2D: nothing
//   nubar = nu / (1 - nu), in plane stress nu.
// So each bending mode has a lateral strain for which the lateral stress vanishes, and the trace of the
// strain vanishes as nu -> 1/2. h_a,j is taken with the Jacobian of the centre, and every Gauss point has the
// volume V / 2^dim. The sum of h_a,j over the cell is then exactly zero: mean strain and q do not couple, and
// the patch test holds on any cell.
//
// Large motion: R and U are those of the mean deformation gradient, and R^T q replaces q (rotation.hpp). The
// energy of a cell does not change in a rigid motion, so momentum and angular momentum are conserved exactly.

#include "fem/elements/element.hpp"
#include "fem/elements/mean_cell.hpp"
#include "fem/elements/rotation.hpp"

namespace femsph::fem {

/// Strain as a polynomial in the reference coordinates: coefficients of xi_m, and of the product of the other
/// two (normal strains, 3D).
template <class T, int dim>
struct AssumedField {
  static constexpr int modes = hourglass_modes<dim>;
  static constexpr int products = dim == 2 ? 0 : 3;
  Symmetric<T, dim> linear[dim]{};
  T product[3][dim]{};

  FEMSPH_INLINE static double weight(int a, int i, int j, double nu, double nubar) {
    if (i == j) return 1;
    if (dim == 2) return -nubar;
    if (a == 3 || a == j) return -nu;
    return a == 3 - i - j ? -nubar : 0;
  }
  /// Calls body(m, a, p) for each term of grad h_a that is linear in a coordinate: xi_m d xi_p / d x.
  template <class Body>
  FEMSPH_INLINE static void each_linear(Body&& body) {
    if constexpr (dim == 2) {
      body(0, 0, 1);
      body(1, 0, 0);
    } else {
#pragma GCC unroll 3
      for (int m = 0; m < 3; ++m) {
        body(m, (m + 1) % 3, (m + 2) % 3);
        body(m, (m + 2) % 3, (m + 1) % 3);
      }
    }
  }

  /// G[d][c] = d xi_d / d x_c.
  FEMSPH_INLINE void expand(const Tensor<T, dim>& G, const T (&q)[modes][dim], double nu, double nubar) {
    each_linear([&](int m, int a, int p) __attribute__((always_inline)) {
#pragma GCC unroll 3
      for (int j = 0; j < dim; ++j) {
        const T t = G[p][j] * q[a][j];
#pragma GCC unroll 3
        for (int i = 0; i < dim; ++i) {
          const double w = weight(a, i, j, nu, nubar);
          linear[m](i, i) += w * t;
          if (dim == 3 && i != j && (a == i || a == j)) linear[m](i, j) += 0.5 * G[p][j] * q[a][i];
        }
      }
    });
#pragma GCC unroll 3
    for (int a = 0; a < products; ++a)
#pragma GCC unroll 3
      for (int j = 0; j < dim; ++j) {
        const T t = G[a][j] * q[modes - 1][j];
        for (int i = 0; i < dim; ++i) product[a][i] += weight(3, i, j, nu, nubar) * t;
      }
  }

  /// The adjoint of expand(): from the moments of the stress, which this field holds, the Q that works on q.
  FEMSPH_INLINE void collect(const Tensor<T, dim>& G, T (&Q)[modes][dim], double nu, double nubar) const {
    for (int a = 0; a < modes; ++a)
      for (int i = 0; i < dim; ++i) Q[a][i] = T{};
    each_linear([&](int m, int a, int p) __attribute__((always_inline)) {
#pragma GCC unroll 3
      for (int j = 0; j < dim; ++j) {
        T t = linear[m](j, j);
#pragma GCC unroll 3
        for (int i = 0; i < dim; ++i)
          if (i != j) {
            t += weight(a, i, j, nu, nubar) * linear[m](i, i);
            if (dim == 3 && (a == i || a == j)) Q[a][i] += G[p][j] * linear[m](i, j);
          }
        Q[a][j] += G[p][j] * t;
      }
    });
#pragma GCC unroll 3
    for (int a = 0; a < products; ++a)
#pragma GCC unroll 3
      for (int j = 0; j < dim; ++j) {
        T t = T{};
        for (int i = 0; i < dim; ++i) t += weight(3, i, j, nu, nubar) * product[a][i];
        Q[modes - 1][j] += G[a][j] * t;
      }
  }

  FEMSPH_INLINE static double coordinate(int m, int q) { return (q >> m) & 1 ? gauss_point : -gauss_point; }
  FEMSPH_INLINE void add_to(int q, Symmetric<T, dim>& strain) const {
    for (int m = 0; m < dim; ++m)
      for (int k = 0; k < symmetric_size<dim>; ++k)
        if (dim == 3 || k < dim) strain[k] += coordinate(m, q) * linear[m][k];
    for (int a = 0; a < products; ++a)
      for (int i = 0; i < dim; ++i)
        strain[i] += coordinate((a + 1) % 3, q) * coordinate((a + 2) % 3, q) * product[a][i];
  }
  FEMSPH_INLINE void add_moments(int q, const Symmetric<T, dim>& stress) {
    for (int m = 0; m < dim; ++m)
      for (int k = 0; k < symmetric_size<dim>; ++k)
        if (dim == 3 || k < dim) linear[m][k] += coordinate(m, q) * stress[k];
    for (int a = 0; a < products; ++a)
      for (int i = 0; i < dim; ++i)
        product[a][i] += coordinate((a + 1) % 3, q) * coordinate((a + 2) % 3, q) * stress[i];
  }
};

struct AssumedStrainElement {
  static constexpr ElementEntry entry{
      .word = "assumed-strain",
      .name = "assumed strain",
      .about = "assumed strain at full integration: does not lock, and sees plastic bending inside a cell"};
  template <int dim>
  static constexpr int points = corners<dim>;
  static constexpr bool own_axes = true;
  static constexpr bool equal_volumes = true;

  /// q <- R^T q (or R q).
  template <bool transposed, class T, int dim, int modes>
  FEMSPH_INLINE static void turn(const Tensor<T, dim>& R, T (&q)[modes][dim]) {
    for (int a = 0; a < modes; ++a) {
      T r[dim];
      for (int i = 0; i < dim; ++i) {
        r[i] = (transposed ? R[0][i] : R[i][0]) * q[a][0];
        for (int k = 1; k < dim; ++k) r[i] += (transposed ? R[k][i] : R[i][k]) * q[a][k];
      }
      for (int i = 0; i < dim; ++i) q[a][i] = r[i];
    }
  }

  template <class Kinematics, class T, int dim, class LawType, class Observer>
  FEMSPH_INLINE static void force(const CellMaterial<LawType>& material, const T* X, const T* u,
                                  [[maybe_unused]] T* state, T* f, Observer& observer) {
    constexpr int modes = hourglass_modes<dim>, n = corners<dim>;
    const double nu = material.elastic.poisson,
                 nubar = material.elastic.plane == Plane::stress ? nu : nu / (1 - nu);
    const MeanCell<T, dim> cell(X);
    Tensor<T, dim> L, G, P;
    T q[modes][dim], Q[modes][dim];
    cell.strain(u, L, q);
    Symmetric<T, dim> mean, sum{};
    const auto frame = Kinematics::template strain<T, dim>(L, mean);
    if constexpr (rotates<Kinematics>) turn<true>(frame, q);

    const T r = 1.0 / cofactors<T, dim>(cell.geometry.linear, G);
    for (int d = 0; d < dim; ++d)
      for (int c = 0; c < dim; ++c) G[d][c] *= r;
    AssumedField<T, dim> field, moments;
    field.expand(G, q, nu, nubar);
    const T weight = cell.volume * (1.0 / n);
    each_point<LawType, n>([&](int p) __attribute__((always_inline)) {
      Symmetric<T, dim> strain = mean;
      field.add_to(p, strain);
      auto stress = advance_law<LawType, T, dim, Kinematics>(
          material.law, strain, state + p * point_state_size<LawType, dim>);
      observer.point(p, weight, frame, strain, stress,
                     history_of<LawType, dim>(state + p * point_state_size<LawType, dim>));
      stress = Kinematics::template conjugate<T, dim>(strain, stress);
      for (int k = 0; k < symmetric_size<dim>; ++k) sum[k] += stress[k];
      moments.add_moments(p, stress);
    });
    moments.collect(G, Q, nu, nubar);
    if constexpr (rotates<Kinematics>) {
      Tensor<T, dim> M{};
      for (int a = 0; a < modes; ++a)
        for (int i = 0; i < dim; ++i)
          for (int j = 0; j < dim; ++j) M[i][j] += Q[a][i] * q[a][j];
      coupled_piola<T, dim>(frame, mean, sum, M, P);
      turn<false>(frame, Q);
    } else {
      Kinematics::template piola<T, dim>(frame, mean, sum, P);
    }
    for (int i = 0; i < dim; ++i) {
      for (int j = 0; j < dim; ++j) P[i][j] *= weight;
      for (int a = 0; a < modes; ++a) Q[a][i] *= weight;
    }
    cell.force(P, Q, f);
  }
};

}  // namespace femsph::fem
