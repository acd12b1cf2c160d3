#pragma once
// Recovered stress of plastic bodies against the yield curve: the same for both methods.

#include <gtest/gtest.h>

#include "model/numerics/principal.hpp"
#include "model/results/flow_limit.hpp"
#include "recovery_support.hpp"

namespace femsph::test {

/// A beam of height 1 bent without shear, fibres in the state of the law at their strain: k x y along x,
/// plane stress; ideally plastic, the core elastic up to 0.3 of the height from the axis. What is read over
/// the height against the law at the exact strain.
struct PlasticErrors {
  double most, raw_most, l2, raw_l2;  ///< largest von Mises stress over the yield stress at the plastic
                                      ///< strain that is read there (raw: at none); error of xx in percent
};
inline Scene plastic_scene(double hardening = 0) {
  Plasticity p;
  p.yield = 1e-3 * E;
  p.hardening = hardening;
  return recovery_scene(std::make_shared<Box>(2, Point{0, -0.5, 0}, Point{3, 1, 0}), Plane::stress, p);
}
inline PlasticErrors plastic_section_of(Discretization& d, double hardening = 0) {
  const double Y = 1e-3 * E, curvature = Y / E / 0.3;
  const int steps = 10;
  Flat u(d.layout().size, 0.0), f(d.layout().size, 0.0), v(d.layout().size, 0.0);
  for (int n = 1; n <= steps; ++n) {
    const double k = curvature * n / steps;
    u = flat_field(d, [&](const Point& x) {
      return Point{
          k * (x[0] - 1.5) * x[1], -0.5 * k * (x[0] - 1.5) * (x[0] - 1.5) - 0.5 * nu * k * x[1] * x[1], 0};
    });
    d.internal_force(u.data(), v.data(), 0, f.data(), nullptr);
  }
  const Recovery rule(d.material_units());
  PlasticErrors out{};
  double e = 0, r = 0, size = 0;
  for (int i = 0; i <= 40; ++i) {
    const Point p{1.5, -0.5 + i / 40.0, 0};
    const Recovered here = read_at(d, rule, u, p, Plane::stress);
    const auto s = here.stress, raw = raw_at(d, u, p);
    Plastic law{LinearElastic::make(E, nu, 7850.0, Plane::stress),
                Plasticity{Y, hardening, TensionRule::none, 0, Integration::return_mapping, {}}, 0};
    Symmetric<double, 2> stress{}, by{curvature * p[1] / steps, -nu * curvature * p[1] / steps, 0};
    double history[4]{};
    for (int n = 0; n < steps; ++n) law.update<double, 2>(by, stress, history);
    e += std::pow(s[0] - stress[0], 2), r += std::pow(raw[0] - stress[0], 2), size += stress[0] * stress[0];
    out.most = std::max(out.most, von_mises(s) / (Y + hardening * here.plastic)),
    out.raw_most = std::max(out.raw_most, von_mises(raw) / Y);
  }
  out.l2 = 100 * std::sqrt(e / size), out.raw_l2 = 100 * std::sqrt(r / size);
  return out;
}

/// Laws whose bounds differ.
inline std::vector<std::pair<const char*, Plasticity>> plastic_laws() {
  Plasticity metal, sign, principal, none, hot;
  metal.yield = 1e-3 * E, metal.hardening = 0.05 * E;
  sign.yield = principal.yield = 1e-3 * E;
  sign.tension = TensionRule::sign, principal.tension = TensionRule::principal;
  sign.tensile_strength = principal.tensile_strength = 2e-4 * E;
  none = metal, none.integration = Integration::tangent;
  hot.yield = 1e-3 * E;
  hot.johnson_cook = JohnsonCook{2e-3 * E, 0.5, 0.05, 1.0, 1, 0, 0, 0, 0};
  return {{"metal", metal}, {"sign", sign}, {"principal", principal}, {"none", none}, {"Johnson-Cook", hot}};
}

/// Drives a body far beyond yield, differently at every point, and compares the stress of its points with the
/// bounds that they state: none lies above, and where the law has a bound, some lie on it.
inline void expect_bounds(Discretization& d, const Plasticity& law, double size) {
  Flat u(d.layout().size, 0.0), v(d.layout().size, 0.0), f(d.layout().size, 0.0);
  for (int n = 1; n <= 20; ++n) {
    const double s = size * n / 20;
    u = flat_field(d, [&](const Point& x) {
      return Point{
          s * (x[0] * x[1] - 0.5 * x[0] * x[0]), s * (0.3 * x[1] * x[1] - x[0]), s * x[2] * (x[0] - x[1])};
    });
    d.internal_force(u.data(), v.data(), 1e-3, f.data(), nullptr);
  }
  std::vector<std::size_t> all(d.material_points());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  MaterialState state;
  d.material_state(u.data(), all, state);
  ASSERT_EQ(state.flow_stress.size(), all.size());
  EXPECT_EQ(state.tensile_flow_stress.empty(), law.tension != TensionRule::sign);
  EXPECT_EQ(state.tensile_strength.empty(), law.tension != TensionRule::principal);
  double nearest = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& s = state.stress[i];
    const bool tension = s[0] + s[1] + s[2] > 0 && !state.tensile_flow_stress.empty();
    const double share = von_mises(s) / (tension ? state.tensile_flow_stress[i] : state.flow_stress[i]);
    EXPECT_LT(share, 1 + 1e-11);
    nearest = std::max(nearest, share);
    if (state.tensile_strength.empty()) continue;
    const double cut = principal_values(s)[0] / state.tensile_strength[i];
    EXPECT_LT(cut, 1 + 1e-11);
    nearest = std::max(nearest, cut);
  }
  if (law.integration == Integration::return_mapping)
    EXPECT_NEAR(nearest, 1, 1e-11);
  else
    EXPECT_EQ(nearest, 0);
}

/// Expects that of all laws in plane strain and in space, in small and in large motion, where laws give
/// Kirchhoff stress and the state Cauchy stress. `discretize(scene)` makes the body of a unit square or cube.
template <class Discretize>
void expect_points_within_bounds(Discretize&& discretize) {
  for (const int dim : {2, 3})
    for (const bool large : {false, true})
      for (const auto& [name, law] : plastic_laws()) {
        SCOPED_TRACE(std::string(name) + (large ? " large" : " small"));
        Scene scene = recovery_scene(std::make_shared<Box>(dim, Point{}, Point{1, 1, dim == 3 ? 1.0 : 0.0}),
                                     dim == 2 ? Plane::strain : Plane::none, law);
        scene.large_motion = large;
        expect_bounds(*discretize(scene), law, large ? 0.2 : 0.02);
      }
}

}  // namespace femsph::test
