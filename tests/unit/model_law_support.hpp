#pragma once
// The steel of the paper (E 210 GPa, nu 0.3, yield 300 MPa, Et = E/100), its concrete, and paths of strain to
// drive a point along.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "model/material/point.hpp"
#include "model/scene/scene.hpp"

namespace femsph::test {

using Strain = std::array<double, 6>;  ///< exx eyy ezz gxy gyz gzx

inline constexpr double young = 210e9, poisson = 0.3, yield_stress = 300e6, hardening = young / 99,
                        shear = young / 2.6;

inline Plastic plastic_law(Plane plane, Plasticity p = {yield_stress, hardening}) {
  return {LinearElastic::make(young, poisson, 7850, plane), p};
}
inline Plasticity with(Integration integration, double h = hardening) {
  return {yield_stress, h, TensionRule::none, 0, integration};
}
/// 30 MPa in compression, 3 in tension.
inline Plasticity concrete(TensionRule rule) { return {30e6, 1e9, rule, 3e6}; }

inline const std::vector<Plane> planes{Plane::stress, Plane::strain, Plane::none};
inline const std::vector<Integration> all_integrations{
    Integration::return_mapping, Integration::tangent, Integration::largest_stress,
    Integration::modulus_mistaken};
/// Every rule of tension with every integration.
inline std::vector<Plasticity> all_parameters() {
  std::vector<Plasticity> all;
  for (Integration integration : all_integrations) {
    all.push_back(with(integration));
    for (TensionRule rule : {TensionRule::sign, TensionRule::principal})
      all.push_back({yield_stress, hardening, rule, 0.1 * yield_stress, integration});
  }
  return all;
}

/// A smooth curved path of `steps` steps that yields in both directions; components that the plane fixes are
/// 0.
inline std::vector<Strain> crooked_path(Plane plane, int steps = 400, double size = 0.006) {
  std::vector<Strain> path;
  for (int k = 1; k <= steps; ++k) {
    const double t = 6.0 * k / steps;
    Strain e{std::sin(t),
             0.7 * std::sin(1.3 * t + 0.4) - 0.7 * std::sin(0.4),
             0.5 * std::sin(0.9 * t),
             1.1 * std::sin(0.8 * t),
             0.6 * std::sin(1.7 * t),
             -0.4 * std::sin(1.1 * t)};
    if (plane != Plane::none) e[2] = e[4] = e[5] = 0;
    for (double& x : e) x *= size;
    path.push_back(e);
  }
  return path;
}

/// The unknown strain component that makes `residual` zero: secant steps, which a piecewise linear law ends
/// at round-off.
inline double root(double a, double b, const std::function<double(double)>& residual) {
  double ra = residual(a), rb = residual(b);
  for (int turn = 0; turn < 100 && ra != rb; ++turn) {
    const double c = b - rb * (b - a) / (rb - ra);
    a = b, ra = rb, b = c, rb = residual(c);
  }
  return b;
}

}  // namespace femsph::test
