#pragma once
// The passes of bond_body.hpp over the bonds. Included by bond_body_2d.cpp and _3d.cpp alone.

#include "model/material/stiffening.hpp"
#include "sph/formulations/bond_body.hpp"
#include "sph/operators/kernel.hpp"

namespace femsph::sph {

/// The least support of a particle: the smallest eigenvalue of M over the mean of all, and that mean, which
/// is about 1 in a whole neighbourhood and 1/8 at the corner of a box.
struct Support {
  double share, mean;
};
inline constexpr Support solid_support{0.03, 0.01}, fluid_support{0.2, 0.2};

/// The inverse of a symmetric moment matrix. A particle with too few neighbours, or with all of them nearly
/// on a line or in a plane, has 0, and feels no stress; in a fluid it has the isotropic dim / tr M, with a
/// mean of at least 0.3.
template <int dim>
FEMSPH_INLINE Symmetric<Pack, dim> inverse_moment(const Symmetric<Pack, dim>& M, bool fluid) {
  const Pack mean = (1.0 / dim) * trace(M);
  Symmetric<Pack, dim> B;
  Pack det, size;
  if constexpr (dim == 2) {
    B[0] = M[1], B[1] = M[0], B[2] = -M[2];
    det = M[0] * M[1] - M[2] * M[2];
    size = mean * mean;
  } else {
    B[0] = M[1] * M[2] - M[4] * M[4], B[1] = M[0] * M[2] - M[5] * M[5], B[2] = M[0] * M[1] - M[3] * M[3];
    B[3] = M[4] * M[5] - M[3] * M[2], B[4] = M[3] * M[5] - M[4] * M[0], B[5] = M[3] * M[4] - M[5] * M[1];
    det = M[0] * B[0] + M[3] * B[3] + M[5] * B[5];
    size = mean * mean * mean;
  }
  const auto regular = det > 1e-12 * size;
  const Pack r = select(regular, 1.0 / select(regular, det, broadcast<Pack>(1.0)), Pack{});
  for (int k = 0; k < symmetric_size<dim>; ++k) B[k] *= r;
  const Support least = fluid ? fluid_support : solid_support;
  const auto sound = regular & (mean > least.mean) & (largest_eigenvalue_bound(B) * mean * least.share < 1.0);
  const Pack alone = fluid ? 1.0 / select(mean > 0.3, mean, broadcast<Pack>(0.3)) : Pack{};
  for (int k = 0; k < symmetric_size<dim>; ++k) B[k] = select(sound, B[k], k < dim ? alone : Pack{});
  return B;
}

/// s(eta) (eta/h)^4, of s = s(eta) and x = eta/h: the weight of the springs. The fourth power gives bonds
/// along the diagonals of a lattice about the same stiffness as those along its axes (sph/README.md).
FEMSPH_INLINE Pack spring_weight(const Pack& s, const Pack& x) {
  const Pack x2 = select(x < 2.0, x * x, Pack{});
  return s * (x2 * x2);
}

template <int dim>
template <class Run>
void BondBody<dim>::with_kernel(Run&& run) const {
  if (kernel_.kind() == KernelKind::wendland_c2)
    run(WendlandC2{});
  else
    run(CubicSpline{});
}

/// max(1, eta/R)^3
FEMSPH_INLINE Pack closeness(const Pack& eta_over_R) {
  const Pack l = select(eta_over_R > 1.0, eta_over_R, broadcast<Pack>(1.0));
  return l * l * l;
}

/// Keeps r = 0, where a lane looks at itself, from becoming 0/0.
inline constexpr double no_length = 1e-60;

template <int dim>
template <class Spline, bool fluid>
void BondBody<dim>::gradients(BondLists& lists, double time) const {
  const double per_h = 1 / kernel_.h(), factor = kernel_.steepness_factor();
  lists.each_block([&](std::size_t block, const BondLists::Bonds& bonds) {
    Pack own[lanes], other[lanes];
    motion_.load_first(block, own);
    Tensor<Pack, dim> G{};
    Symmetric<Pack, dim> M{};
    const double* eta = bonds.eta;
    for (const std::int32_t* index = bonds.index; index != bonds.end; index += lanes) {
      motion_.gather_first(index, other);
      Pack d[dim], w[dim], r2 = broadcast<Pack>(no_length);
      for (int c = 0; c < dim; ++c) d[c] = other[middle + c] - own[middle + c], r2 += d[c] * d[c];
      Pack s = other[measure];
      if constexpr (fluid) {
        s *= Spline::steepness(per_h * square_root(r2));
      } else {
        const Pack length = load<Pack>(eta), a = Spline::steepness(per_h * length);
        s *= select(a > 0.0, a * closeness(length / square_root(r2)), Pack{});
        eta += lanes;
      }
      for (int c = 0; c < dim; ++c) w[c] = s * d[c];
      for (int r = 0; r < dim; ++r) {
        const Pack dv = other[velocity + r] - own[velocity + r];
        for (int c = 0; c < dim; ++c) G[r][c] += dv * w[c];
        for (int c = r; c < dim; ++c) M(r, c) += d[r] * w[c];
      }
    }
    for (int k = 0; k < n; ++k) M[k] *= factor;
    const Symmetric<Pack, dim> B = inverse_moment<dim>(M, fluid);
    for (int r = 0; r < dim; ++r)
      for (int c = 0; c < dim; ++c) {
        Pack L = G[r][0] * B(0, c);
        for (int k = 1; k < dim; ++k) L += G[r][k] * B(k, c);
        store(&l_[(block * dim * dim + std::size_t(r * dim + c)) * lanes], (factor * time) * L);
      }
  });
}

template <int dim>
template <class Spline, bool fluid, bool flowing, bool with_viscosity>
void BondBody<dim>::bond_forces(BondLists& lists, const Step& step, double* f,
                                [[maybe_unused]] double* viscous) const {
  const double h = kernel_.h(), per_h = 1 / h, factor = kernel_.steepness_factor();
  [[maybe_unused]] const double spring = spring_ * factor,
                                alpha = options_.viscosity.alpha * wave_speed_ * density_,
                                beta = options_.viscosity.beta * density_,
                                floor = options_.viscosity.gamma * h * h + no_length;
  lists.each_block([&](std::size_t block, const BondLists::Bonds& bonds) {
    Pack own[MotionRecords::fields], other[MotionRecords::fields], force[dim] = {}, drag[dim] = {};
    motion_.load_block(block, own);
    [[maybe_unused]] Pack kept{}, forgotten{};
    if constexpr (flowing) kept = load<Pack>(&kept_[block * lanes]);
    Symmetric<Pack, dim> M{}, S{};
    Pack grip{};
    std::size_t k = 0;
    for (const std::int32_t* index = bonds.index; index != bonds.end; index += lanes, k += lanes) {
      motion_.gather(index, other);
      Pack d[dim], dv[dim], r2 = broadcast<Pack>(no_length), m2 = r2, along{};
      for (int c = 0; c < dim; ++c) {
        const Pack mid = other[middle + c] - own[middle + c];
        dv[c] = other[velocity + c] - own[velocity + c];
        along += mid * dv[c], m2 += mid * mid;
        d[c] = mid + step.half * dv[c];
        r2 += d[c] * d[c];
      }
      const Pack R = square_root(r2);
      Pack s, w;
      if constexpr (fluid) {
        s = w = Spline::steepness(per_h * R);
      } else {
        Pack bent{};  // r . (D_i + D_j) r
        for (int r = 0; r < dim; ++r) {
          const Pack a = other[middle + r] - own[middle + r];
          for (int c = r; c < dim; ++c) {
            const int at = rate + symmetric_index<dim>(r, c);
            const Pack term = (own[at] + other[at]) * (a * (other[middle + c] - own[middle + c]));
            bent += r == c ? term : 2.0 * term;
          }
        }
        const Pack m = square_root(m2), grown = (step.time * along - 0.5 * bent) / m;
        Pack eta = load<Pack>(bonds.eta + k), q = load<Pack>(bonds.misfit + k);
        const Pack stiff = spring * load<Pack>(bonds.volumes + k);
        s = Spline::steepness(per_h * eta);
        const Pack q_before = q, s_before = s;
        q = select(s > 0.0, q + grown, Pack{});
        if constexpr (flowing) {
          Pack other_kept;
          for (int l = 0; l < lanes; ++l) other_kept[l] = kept_[std::size_t(index[l])];
          const Pack keep = 0.5 * (kept + other_kept);
          if (any(keep < 1.0)) {
            // Memory decays with the flow: eta' = rate (R - eta), q' = m - rate q, with exp(-rate dt) = keep.
            const Pack root = square_root(keep), start = 2.0 * m - R;
            const Pack before = stiff * spring_weight(s_before, per_h * eta) * q_before;
            eta = select(keep < 1.0, R + keep * (eta - start) - root * (R - start), eta);
            store(bonds.eta + k, eta);
            s = Spline::steepness(per_h * eta);
            q = select(s > 0.0, root * (root * q_before + grown), Pack{});
            const Pack after = stiff * spring_weight(s, per_h * eta) * q;
            forgotten += before * q_before - after * q + (before + after) * grown;
          }
        }
        store(bonds.misfit + k, q);
        const Pack per_R = 1.0 / R, t = stiff * spring_weight(s, per_h * eta) * q * per_R;
        w = select(s > 0.0, s * closeness(eta * per_R), Pack{});
        for (int r = 0; r < dim; ++r) {
          const Pack pulled = t * d[r];
          force[r] += pulled;
          for (int c = r; c < dim; ++c) S(r, c) += pulled * d[c];
        }
      }
      store(bonds.weight + k, w);
      const Pack there = w * other[measure];
      grip += there;
      for (int r = 0; r < dim; ++r)
        for (int c = r; c < dim; ++c) M(r, c) += there * d[r] * d[c];
      if constexpr (with_viscosity) {
        Pack closing{};
        for (int r = 0; r < dim; ++r) closing += dv[r] * d[r];
        const Pack phi = h * select(closing < 0.0, closing, Pack{}) / (r2 + floor);
        Pack volumes;
        if constexpr (fluid)
          volumes = own[measure] * other[measure];
        else
          volumes = load<Pack>(bonds.volumes + k);
        const Pack p = (alpha - beta * phi) * phi * s * volumes;
        for (int r = 0; r < dim; ++r) drag[r] += p * d[r];
      }
    }
    for (int c = 0; c < n; ++c) M[c] *= factor;
    const Symmetric<Pack, dim> B = inverse_moment<dim>(M, fluid);
    Symmetric<Pack, dim> N;
    for (int c = 0; c < n; ++c) {
      N[c] = load<Pack>(&resultant_[(block * n + std::size_t(c)) * lanes]) * thickness_;
      if constexpr (!fluid) N[c] -= 0.5 * S[c];
    }
    Pack record[ForceRecords::fields] = {}, pulls{};
    for (int r = 0; r < dim; ++r) {
      record[place + r] = own[middle + r] + step.half * own[velocity + r];
      for (int c = 0; c < dim; ++c) {
        Pack Q = N(r, 0) * B(0, c);
        for (int l = 1; l < dim; ++l) Q += N(r, l) * B(l, c);
        pulls += Q * Q;
        record[pull + r * dim + c] = factor * Q;
      }
    }
    record[extent] = own[measure];
    forces_.store_block(block, record);
    store(&grip_[block * lanes], grip * largest_eigenvalue_bound(B));
    store(&tension_[block * lanes],
          grip * square_root(pulls) * select(trace(N) < 0.0, broadcast<Pack>(2.0), broadcast<Pack>(1.0)));
    const Pack own_part = part(block);
    if constexpr (flowing)
      store(&forgotten_[block * lanes], load<Pack>(&forgotten_[block * lanes]) + own_part * forgotten);
    for (int r = 0; r < dim; ++r) {
      store(f + slot(block, r), force[r]);
      if constexpr (with_viscosity)
        store(viscous + slot(block, r), (own_part * (factor * thickness_)) * drag[r]);
    }
  });
}

template <int dim>
void BondBody<dim>::divergence(BondLists& lists, double* f) const {
  lists.each_block([&](std::size_t block, const BondLists::Bonds& bonds) {
    Pack own[ForceRecords::fields], other[ForceRecords::fields], force[dim] = {};
    forces_.load_block(block, own);
    const double* weight = bonds.weight;
    for (const std::int32_t* index = bonds.index; index != bonds.end; index += lanes, weight += lanes) {
      forces_.gather(index, other);
      const Pack w = load<Pack>(weight), mine = w * other[extent], its = w * own[extent];
      Pack d[dim];
      for (int c = 0; c < dim; ++c) d[c] = other[place + c] - own[place + c];
      for (int r = 0; r < dim; ++r)
        for (int c = 0; c < dim; ++c)
          force[r] += (mine * own[pull + r * dim + c] + its * other[pull + r * dim + c]) * d[c];
    }
    const Pack own_part = part(block);
    for (int r = 0; r < dim; ++r)
      store(f + slot(block, r), own_part * (load<Pack>(f + slot(block, r)) + force[r]));
  });
}

/// Minus the linear part of the viscous force at velocity x of the undeformed body, as if all pairs
/// approached.
template <int dim>
template <class Spline>
void BondBody<dim>::damping(BondLists& lists, double* y) const {
  const double h = kernel_.h(), floor = options_.viscosity.gamma * h * h + no_length;
  const double scale = options_.viscosity.alpha * wave_speed_ * density_ * h * kernel_.steepness_factor() *
                       thickness_;
  lists.each_block([&](std::size_t block, const BondLists::Bonds& bonds) {
    Pack own[lanes], other[lanes], drag[dim] = {};
    motion_.load_first(block, own);
    std::size_t k = 0;
    for (const std::int32_t* index = bonds.index; index != bonds.end; index += lanes, k += lanes) {
      motion_.gather_first(index, other);
      Pack d[dim], r2 = broadcast<Pack>(no_length), closing{};
      for (int c = 0; c < dim; ++c) {
        d[c] = other[middle + c] - own[middle + c], r2 += d[c] * d[c];
        closing += (other[velocity + c] - own[velocity + c]) * d[c];
      }
      const Pack volumes = fluid_ ? own[measure] * other[measure] : load<Pack>(bonds.volumes + k);
      const Pack p = volumes * Spline::steepness(square_root(r2) * (1 / h)) * closing / (r2 + floor);
      for (int c = 0; c < dim; ++c) drag[c] += p * d[c];
    }
    for (int c = 0; c < dim; ++c) store(y + slot(block, c), (part(block) * -scale) * drag[c]);
  });
}

}  // namespace femsph::sph
