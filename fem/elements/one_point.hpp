#pragma once
// The one-point element: the mean strain at one material point, and a control of the hourglass modes q =
// gamma . u, which the mean strain does not contain (mean_cell.hpp). There are two controls. Each adds its
// nodal forces Q = dW/dq, and its energy W counts as hourglass energy.
//
// PhysicalStabilization, without a parameter: the energy of the strains that are linear over the cell,
// assumed in its natural axes as in the hybrid elements of Pian & Sumihara (Int. J. Numer. Meth. Engng 20
// (1984) 1685-1695) and Pian & Tong (ibid. 22 (1986) 173-181). With A_d the tangents at the centre, l_d =
// |A_d|^2, s_ad = A_d . q_a / l_d and V the volume
//   2D  W = V/6 Eb (s_0^2 + s_1^2)
//   3D  W = V/6 sum_m { Eb (s_fe^2 + s_ef^2 + 2 nu s_fe s_ef) + mu (l_e s_ee + l_f s_ff)^2 / (l_e l_f) } +
//   V/18 E sum_d s_4d^2,
//       e = m + 1, f = m + 2 (cyclic): bending in both directions of the plane normal to axis m, the twist of
//       that plane, and the mode xi eta zeta.
// Eb is the modulus of bending, E / (1 - nu^2), in plane stress E. The stress normal to the fibres vanishes,
// so the stiffness stays bounded as nu -> 1/2. On a rectangle or a box these are exactly the assumed strains
// of assumed_strain.hpp (there A_d . A_e = 0), on a parallelogram the stiffness of Pian & Sumihara, which is
// exact in pure bending.
//
// Large motion: A_d rotates with the R of the mean deformation gradient. W depends on R^T q alone, so it is
// zero in a rigid motion. The change of R is balanced by the couple of rotation.hpp, which conserves angular
// momentum to round-off.
//
// Plastic laws, by deformation theory. Where the cell's point has flowed, the moduli are reduced to the
// secant moduli, times rho = Y / (Y + 3 mu p). The energy that W loses as p grows is added to the plastic
// work of the point. A fibre carries at most the yield stress sigma (hourglass_moduli.hpp): from x = 1 on,
// where the linear strains bring the edges of the cell to yield, x^2 = rho W / (V w_y), w_y = sigma^2 / (6
// Eb), the moment is that of an ideally plastic rectangular section, M / M_y = 3/2 - 1/(2 x^2) with x the
// curvature over that at first yield. For x < 1 and p = 0 the control is the elastic one.

#include "fem/elements/element.hpp"
#include "fem/elements/mean_cell.hpp"
#include "fem/elements/rotation.hpp"

namespace femsph::fem {

/// A law that flows by von Mises' rule and keeps its plastic work, J/m^3, in the slot `work` of its history.
template <class LawType>
concept MisesPlastic = requires(const LawType& law) {
  LawType::plasticity(law.parameters);
  LawType::work;
};

/// By how much plastic flow has reduced the moduli of a point.
template <class T>
struct Softening {
  T ratio;  ///< rho: secant over elastic modulus
  T drop;   ///< of rho in this step
};

struct PhysicalStabilization {
  static constexpr bool softens = true;
  /// Replaces q by Q, and adds the couple of Q to P, the stress that works on the mean gradient.
  template <class Kinematics, class LawType, class T, int dim, class Frame, class Observer>
  FEMSPH_INLINE static void apply(
      const HourglassModuli& moduli, const MeanCell<T, dim>& cell, [[maybe_unused]] const Frame& frame,
      [[maybe_unused]] const Symmetric<T, dim>& strain, [[maybe_unused]] const Softening<T>& soft,
      [[maybe_unused]] T* history, T (&q)[hourglass_modes<dim>][dim], Tensor<T, dim>& P, Observer& observer) {
    constexpr int modes = hourglass_modes<dim>;
    const Tensor<T, dim>& A = cell.geometry.linear;
    T square[dim], inverse[dim], s[modes][dim], tau[modes][dim];
    Tensor<T, dim> b;  // A_d / l_d, turned
    for (int d = 0; d < dim; ++d) {
      square[d] = A[d][0] * A[d][0];
      for (int c = 1; c < dim; ++c) square[d] += A[d][c] * A[d][c];
    }
    inverses(square, inverse);
    for (int d = 0; d < dim; ++d)
      for (int i = 0; i < dim; ++i) {
        if constexpr (rotates<Kinematics>) {
          b[d][i] = frame[i][0] * A[d][0];
          for (int c = 1; c < dim; ++c) b[d][i] += frame[i][c] * A[d][c];
          b[d][i] *= inverse[d];
        } else {
          b[d][i] = inverse[d] * A[d][i];
        }
      }
    for (int a = 0; a < modes; ++a)
      for (int d = 0; d < dim; ++d) {
        s[a][d] = b[d][0] * q[a][0];
        for (int i = 1; i < dim; ++i) s[a][d] += b[d][i] * q[a][i];
      }
    stresses(moduli, cell.volume, square, inverse, s, tau);

    T energy = T{};
    for (int a = 0; a < modes; ++a)
      for (int d = 0; d < dim; ++d) energy += 0.5 * tau[a][d] * s[a][d];
    if constexpr (MisesPlastic<LawType>) {
      const T per_volume = cell.scale * (1.0 / corners<dim>);  // 1/V
      T factor = soft.ratio, slope = energy;                   // slope = dW / d rho
      const T x2 = factor * factor * energy * per_volume * (1 / moduli.yield_energy);
      energy *= factor;
      if (any(x2 > 1.0)) {
        const auto flows = x2 > 1.0;
        const T limit = cell.volume * moduli.yield_energy / factor;
        const T r = 1.0 / square_root(select(flows, x2, broadcast<T>(1.0)));
        energy = select(flows, limit * (3.0 / r + r - 3.0), energy);
        slope = select(flows, limit / factor * (3.0 - 2.0 * r), slope);
        factor *= r * (1.5 - 0.5 * r * r);
      }
      for (int a = 0; a < modes; ++a)
        for (int d = 0; d < dim; ++d) tau[a][d] *= factor;
      if (any(soft.drop > 0.0)) history[LawType::work] += slope * soft.drop * per_volume;
    }
    observer.hourglass(energy);

    T Q[modes][dim];
    for (int a = 0; a < modes; ++a)
      for (int i = 0; i < dim; ++i) {
        Q[a][i] = tau[a][0] * b[0][i];
        for (int d = 1; d < dim; ++d) Q[a][i] += tau[a][d] * b[d][i];
      }
    if constexpr (rotates<Kinematics>) add_couple<T, dim>(frame, strain, q, Q, P);
    for (int a = 0; a < modes; ++a)
      for (int i = 0; i < dim; ++i) q[a][i] = Q[a][i];
  }

 private:
  template <class T>
  FEMSPH_INLINE static void inverses(const T (&x)[2], T (&y)[2]) {
    const T r = 1.0 / (x[0] * x[1]);
    y[0] = r * x[1];
    y[1] = r * x[0];
  }
  template <class T>
  FEMSPH_INLINE static void inverses(const T (&x)[3], T (&y)[3]) {
    const T xy = x[0] * x[1], r = 1.0 / (xy * x[2]), rz = r * x[2];
    y[0] = rz * x[1];
    y[1] = rz * x[0];
    y[2] = r * xy;
  }

  /// tau = dW/ds.
  template <class T>
  FEMSPH_INLINE static void stresses(const HourglassModuli& m, const T& volume, const T (&)[2],
                                     const T (&)[2], const T (&s)[1][2], T (&tau)[1][2]) {
    const T k = (m.bending / 3) * volume;
    for (int d = 0; d < 2; ++d) tau[0][d] = k * s[0][d];
  }
  template <class T>
  FEMSPH_INLINE static void stresses(const HourglassModuli& m, const T& volume, const T (&l)[3],
                                     const T (&inverse)[3], const T (&s)[4][3], T (&tau)[4][3]) {
    const T third = (1.0 / 3) * volume, bending = m.bending * third, shear = m.shear * third,
            corner = (m.uniaxial / 3) * third;
    T twist[3];
    for (int d = 0; d < 3; ++d) {
      const int e = (d + 1) % 3, f = (d + 2) % 3;
      tau[f][e] = bending * (s[f][e] + m.poisson * s[e][f]);
      tau[e][f] = bending * (s[e][f] + m.poisson * s[f][e]);
      twist[d] = shear * (l[e] * s[e][e] + l[f] * s[f][f]);
      tau[3][d] = corner * s[3][d];
    }
    for (int d = 0; d < 3; ++d) {
      const int e = (d + 1) % 3, f = (d + 2) % 3;
      tau[d][d] = twist[e] * inverse[f] + twist[f] * inverse[e];
    }
  }

  template <class T, int dim, class Frame>
  FEMSPH_INLINE static void add_couple(const Frame& R, Symmetric<T, dim> U,
                                       const T (&q)[hourglass_modes<dim>][dim],
                                       const T (&Q)[hourglass_modes<dim>][dim], Tensor<T, dim>& P) {
    for (int i = 0; i < dim; ++i) U[i] += 1.0;
    Tensor<T, dim> Z;
    if constexpr (dim == 2) {
      Z = axial_couple<T>(U, q[0][0] * Q[0][1] - q[0][1] * Q[0][0]);
    } else {
      T moment[3]{}, axial[3];
      for (int a = 0; a < 4; ++a) {
        T c[3];
        cross(q[a], Q[a], c);
        for (int i = 0; i < 3; ++i) moment[i] += c[i];
      }
      for (int i = 0; i < 3; ++i) axial[i] = R[0][i] * moment[0] + R[1][i] * moment[1] + R[2][i] * moment[2];
      Z = axial_couple<T>(U, axial);
    }
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        for (int k = 0; k < dim; ++k)
          if (k != j) P[i][j] += R[i][k] * Z[k][j];
  }
};

/// Stiffness control of Flanagan and Belytschko (1981) with a coefficient: per mode and component
///   W = 1/2 k 2^dim q^2,  k = coefficient M V sum_aI (dN_I/dx_a)^2,
/// with M of hourglass_modulus; (lambda + 2 mu) V sum (dN/dx)^2 is their bound on the stiffness of the mean
/// strain. W depends on the length of q alone, so it is objective. The coefficient is a choice: a cell in
/// pure bending is as stiff as the coefficient says.
struct PerturbationControl {
  static constexpr bool softens = false;
  template <class Kinematics, class LawType, class T, int dim, class Frame, class Observer>
  FEMSPH_INLINE static void apply(const HourglassModuli& moduli, const MeanCell<T, dim>& cell, const Frame&,
                                  const Symmetric<T, dim>&, const Softening<T>&, T*,
                                  T (&q)[hourglass_modes<dim>][dim], Tensor<T, dim>&, Observer& observer) {
    const T k = (moduli.perturbation * corners<dim>)*cell.volume * cell.gradient_square();
    T energy = T{};
    for (int a = 0; a < hourglass_modes<dim>; ++a)
      for (int i = 0; i < dim; ++i) {
        energy += 0.5 * k * q[a][i] * q[a][i];
        q[a][i] *= k;
      }
    observer.hourglass(energy);
  }
};

/// Mean gradient, one material point, and a control of the hourglass modes.
template <class Control>
struct OnePoint {
  template <int dim>
  static constexpr int points = 1;
  static constexpr bool own_axes = false;
  static constexpr bool equal_volumes = true;

  template <class Kinematics, class T, int dim, class LawType, class Observer>
  FEMSPH_INLINE static void force(const CellMaterial<LawType>& material, const T* X, const T* u, T* state,
                                  T* f, Observer& observer) {
    const MeanCell<T, dim> cell(X);
    Tensor<T, dim> L, P;
    T q[hourglass_modes<dim>][dim];
    cell.strain(u, L, q);
    Symmetric<T, dim> strain;
    const auto frame = Kinematics::template strain<T, dim>(L, strain);
    T* const history = history_of<LawType, dim>(state);
    Softening<T> soft{broadcast<T>(1.0), T{}};
    if constexpr (Control::softens && MisesPlastic<LawType>)
      soft.drop = -material.law.plastic_strain(history);
    const auto stress = advance_law<LawType, T, dim, Kinematics>(material.law, strain, state);
    if constexpr (Control::softens && MisesPlastic<LawType>)
      soften(material.law, material.law.plastic_strain(history), soft);
    observer.point(0, cell.volume, frame, strain, stress, history);
    Kinematics::template piola<T, dim>(frame, strain, stress, P);
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) P[i][j] *= cell.volume;
    Control::template apply<Kinematics, LawType, T, dim>(
        material.hourglass, cell, frame, strain, soft, history, q, P, observer);
    cell.force(P, q, f);
  }

 private:
  /// rho = Y / (Y + 3 mu p), d rho / dp = -3 mu Y_0 / (Y + 3 mu p)^2, p the plastic strain now. On entry
  /// `drop` is minus the plastic strain before the step.
  template <class LawType, class T>
  FEMSPH_INLINE static void soften(const LawType& law, const T& p, Softening<T>& soft) {
    soft.drop += p;
    if (!any(p > 0.0)) return;
    const Plasticity& plasticity = *LawType::plasticity(law.parameters);
    const double mu = law.elastic().mu;
    const T yield = plasticity.yield + plasticity.hardening * p, r = 1.0 / (yield + 3 * mu * p);
    soft.ratio = yield * r;
    soft.drop *= 3 * mu * plasticity.yield * r * r;
  }
};

struct OnePointElement : OnePoint<PhysicalStabilization> {
  static constexpr ElementEntry entry{
      .word = "one-point",
      .name = "one point",
      .about = "one point a cell, bending and twist by a physical stabilization; does not lock, cheapest",
      .hourglass_control = "physical stabilization"};
  using Controlled = OnePoint<PerturbationControl>;
};

}  // namespace femsph::fem
