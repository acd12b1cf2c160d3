#pragma once
// Von Mises plasticity, for metals and, with a tension rule, for concrete as in the paper.
//
//   yield      f = q - Y,  q = sqrt(3/2 s:s) (von Mises),  Y = yield + hardening p
//              (linear isotropic hardening; eq. 8 of the paper)
//   flow       d eps^p = dp 3 s / (2 q),  p the equivalent plastic strain
//
// The tension rule and the integration of the stress are parameters of one law, so that kernels are compiled
// once for all of them. The elastic step, the yield test of eight points and the return mapping are inlined
// in the kernels; all other rules are one function call, flow(). Parts: return_mapping.hpp, no_return.hpp,
// tension.hpp, johnson_cook.hpp.

#include <optional>
#include <utility>

#include "model/material/laws/equation_of_state.hpp"
#include "model/material/laws/flow_stress.hpp"
#include "model/material/laws/return_mapping.hpp"
#include "model/numerics/elementary.hpp"

namespace femsph {

enum class TensionRule {
  /// The same yield stress in tension and compression.
  none,
  /// The yield stress is `tensile_strength` where the trial mean stress is tensile (the concrete of the
  /// paper: 30 MPa and 3 MPa).
  sign,
  /// No principal stress exceeds `tensile_strength` (Rankine): principal stresses are cut off after the von
  /// Mises step.
  principal,
};

/// How stress follows strain beyond yield. The paper shows results "without return mapping" and does not say
/// how they were computed: all but return_mapping are hypotheses about that.
enum class Integration {
  return_mapping,  ///< backward Euler, radial (projected in plane stress)
  tangent,  ///< hypothesis 1: tangent D^ep (eq. 8) when f >= 0 and loading; Y follows the plastic strain
  largest_stress,    ///< hypothesis 3: the same, but Y is the largest equivalent stress so far
  modulus_mistaken,  ///< hypothesis 8: as 1, but Y increases by E dp instead of H dp (an error in eq. 10)
};

/// The parameters of johnson_cook.hpp. C = 0: no effect of the strain rate; melting = 0: none of temperature.
struct JohnsonCook {
  double B = 0, n = 1;                             ///< Pa, 1
  double C = 0, rate = 1;                          ///< 1, pdot_0 in 1/s
  double m = 1, melting = 0, room = 0, start = 0;  ///< 1, K: T_melt, T_room, T_0
  double heating = 0;                              ///< chi / (rho c), K m^3/J
};

/// The parameters of a plastic material.
struct Plasticity {
  double yield = 0;      ///< Pa
  double hardening = 0;  ///< H = dY/dp, Pa
  TensionRule tension = TensionRule::none;
  double tensile_strength = 0;  ///< Pa; sign and principal only
  Integration integration = Integration::return_mapping;
  /// Replaces `hardening`; only with return mapping and without a tension rule.
  std::optional<JohnsonCook> johnson_cook = {};
  /// Gives the mean stress; the law is then PlasticWithEos (plastic_with_eos.hpp).
  std::optional<EquationOfState> eos = {};

  /// Whether the yield stress is constant (perfect plasticity).
  bool perfect() const { return hardening == 0 && !johnson_cook; }
};

/// The words for stress integration: "return", "no-return-1", ..
const std::vector<std::pair<std::string, Integration>>& integrations();

struct Plastic {
  using Parameters = Plasticity;
  static constexpr const char* name = "plastic";
  // Description and reading of the keys: plastic_keys.cpp.
  static Entry entry();
  static std::vector<KeyTable> tables();
  static Parameters read(Fields& fields, const LawInput& in);
  static std::vector<std::string> effects(const Parameters& p);
  static BarYield bar(const Parameters& p);
  static const Plasticity* plasticity(const Parameters& p) { return &p; }
  static Plastic of(const Parameters& p, const ElasticConstants& m, Plane plane) {
    return {LinearElastic::make(m.young, m.poisson, m.density, plane), p};
  }

  LinearElastic base;
  Plasticity parameters;
  double step = 0;  ///< the time (s) of the next strain increments; 0: not known
  void set_step(double dt) { step = dt; }

  /// The history of a point: equivalent plastic strain; plastic work, J/m^3; `excess`, by how much the
  /// largest equivalent stress so far exceeds the initial yield stress (hypothesis 3, Pa), or the plastic
  /// strain increment of the last step (Johnson-Cook); `across`, the stress normal to the plane (plane
  /// strain, Pa) or the plastic strain normal to the plane (plane stress).
  enum Slot { equivalent_strain, work, excess, across };
  static constexpr int seldom = excess;  ///< the entry that few steps read
  template <int dim>
  static constexpr int history_size = dim == 2 ? 4 : 3;
  static constexpr bool path_independent = false;

  /// Advances stress and history by a strain increment. If no lane yields, only p is read of the history, and
  /// nothing is written in plane stress and in space, so that most points cost little more than elastic ones.
  template <class T, int dim>
  FEMSPH_INLINE void update(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress, T* history) const {
    if (parameters.integration == Integration::return_mapping && parameters.tension == TensionRule::none &&
        !parameters.johnson_cook) {
      const plastic::PointStress<T, dim> trial = elastic_step(increment, stress, history);
      const T yield = parameters.yield + parameters.hardening * history[equivalent_strain];
      if (!any(plastic::von_mises_square(trial) > yield * yield)) {
        stress = trial.in;
        if constexpr (dim == 2) {
          if (base.plane == Plane::strain) history[across] = trial.across;
        }
        return;
      }
      plastic::PointStress<T, dim> now = trial;
      const plastic::Flow<T> step = plastic::return_to_surface(base, parameters.hardening, yield, now);
      if (dim == 3 || base.plane == Plane::strain)
        note<true>(trial, now, step, stress, history);
      else
        note<false>(trial, now, step, stress, history);
      return;
    }
    const Symmetric<T, dim> by =
        increment;  // copies: what the kernel holds in registers must not have an address
    Symmetric<T, dim> to = stress;
    flow(by, to, history);
    stress = to;
  }

  /// update() for all rules, whether points yield or not. In plastic.cpp for T = double and Pack, dim = 2 and
  /// 3.
  template <class T, int dim>
  void flow(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress, T* history) const;

  /// Sets stress and history at the end of a step from `stress` to `now` with the trial stress `trial`.
  /// `traceless`: now - trial is deviatoric, as after a radial return.
  template <bool traceless, class T, int dim>
  FEMSPH_INLINE void note(const plastic::PointStress<T, dim>& trial, const plastic::PointStress<T, dim>& now,
                          const plastic::Flow<T>& step, Symmetric<T, dim>& stress, T* history) const {
    history[equivalent_strain] += step.equivalent;
    Symmetric<T, dim> sum, lost;
    for (int k = 0; k < symmetric_size<dim>; ++k) {
      sum[k] = stress[k] + now.in[k];
      lost[k] = trial.in[k] - now.in[k];
    }
    const T sum_across = stress_across<T, dim>(history) + now.across, lost_across = trial.across - now.across;
    if constexpr (traceless)
      history[work] += (contract(sum, lost) + sum_across * lost_across) * (0.25 / base.mu);
    else
      history[work] += 0.5 * compliance<T, dim>(sum, sum_across, lost, lost_across);
    if constexpr (dim == 2) {
      if (base.plane == Plane::strain)
        history[across] = now.across;
      else
        history[across] += step.across;
    }
    stress = now.in;
  }

  /// The trial stress: that of an elastic step.
  template <class T, int dim>
  FEMSPH_INLINE plastic::PointStress<T, dim> elastic_step(
      const Symmetric<T, dim>& increment, const Symmetric<T, dim>& stress, const T* history) const {
    plastic::PointStress<T, dim> trial{stress, stress_across<T, dim>(history)};
    base.update<T, dim>(increment, trial.in, nullptr);
    if (dim == 2 && base.plane == Plane::strain) trial.across += base.lambda * trace(increment);
    return trial;
  }

  /// a : C^-1 : b of three-dimensional stresses, (a:b - nu/(1 + nu) tr a tr b) / 2G. In 2D the components
  /// normal to the plane are passed separately.
  template <class T, int dim>
  FEMSPH_INLINE T compliance(const Symmetric<T, dim>& a, const T& a_across, const Symmetric<T, dim>& b,
                             const T& b_across) const {
    const double share = base.poisson / (1 + base.poisson);
    return (contract(a, b) + a_across * b_across - share * (trace(a) + a_across) * (trace(b) + b_across)) *
           (0.5 / base.mu);
  }

  /// Stress normal to the plane, for any T.
  template <class T, int dim>
  FEMSPH_INLINE T stress_across(const T* history) const {
    if constexpr (dim == 2) {
      if (base.plane == Plane::strain) return history[across];
    }
    return broadcast<T>(0.0);
  }

  /// 1/2 sigma : C^-1 : sigma (J/m^3), with the stress normal to the plane.
  template <class T, int dim>
  FEMSPH_INLINE T stored_energy(const Symmetric<T, dim>&, const Symmetric<T, dim>& stress,
                                const T* history) const {
    const T normal = stress_across<T, dim>(history);
    return 0.5 * compliance<T, dim>(stress, normal, stress, normal);
  }

  /// In large motion the moduli relate the Kirchhoff stress tau to the logarithmic strain at any stretch.
  /// Along the smallest principal stretch dP/dF = g (lambda + 2 mu - tau); tau is approximated by the mean
  /// stress K ln J, since yielding limits its deviator.
  template <class T>
  FEMSPH_INLINE T stiffening(const T& g, const T& J) const {
    const double bulk = base.lambda + 2.0 / 3 * base.mu;
    return g * (1.0 + plastic::larger(-(bulk / (base.lambda + 2 * base.mu)) * natural_log(J), T{}));
  }
  const LinearElastic& elastic() const { return base; }
  double wave_speed() const { return base.wave_speed(); }
  double thickness_stress(const Symmetric<double, 2>&, const Symmetric<double, 2>&,
                          const double* history) const {
    return stress_across<double, 2>(history);
  }
  /// 0 in plane strain; in plane stress the elastic part -nu/E (sxx + syy) and the plastic part.
  double thickness_strain(const Symmetric<double, 2>&, const Symmetric<double, 2>& s,
                          const double* history) const {
    if (base.plane != Plane::stress) return 0;
    return -base.poisson / (2 * base.mu * (1 + base.poisson)) * (s[0] + s[1]) + history[across];
  }
  template <class T>
  FEMSPH_INLINE T plastic_strain(const T* history) const {
    return history[equivalent_strain];
  }
  /// Work of the stress that is not stored, J/m^3: the sum over the steps of the mean stress of the step : (d
  /// eps - C^-1 d sigma). With this sum the energy balance of the leap-frog closes to round-off. Negative for
  /// a law that creates energy.
  template <class T>
  FEMSPH_INLINE T plastic_work(const T* history) const {
    return history[work];
  }
};

/// Infinite without return mapping, where the stress may exceed the yield stress. For the Johnson-Cook law
/// the yield stress at the rate and temperature of the last step, but at least the present stress, which the
/// strain rate may have raised before.
FlowStress flow_stress(const Plastic& law, const double* history, double share,
                       const std::array<double, 6>& cauchy);

}  // namespace femsph
