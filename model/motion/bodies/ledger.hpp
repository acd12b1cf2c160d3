#pragma once

namespace femsph {

/// The energy balance of a run, J, at a whole step n. `kinetic` is 1/2 v . M v with v = (v(n-1/2) + v(n+1/2))
/// / 2. The sum of energies that the leap-frog conserves to round-off in a linear system has 1/2 v(n-1/2) . M
/// v(n+1/2) instead. `discrete` is the difference of the two, -dt^2/8 a . M a, minus its value at the start.
/// It is negative when the accelerations are larger than at the start, vanishes with dt^2, and is no energy
/// of the bodies.
struct Ledger {
  double kinetic = 0;
  double strain = 0;     ///< stored by the law
  double hourglass = 0;  ///< stored by hourglass control
  double external = 0;   ///< work of loads, gravity and prescribed motion
  double damping = 0;    ///< dissipated by mass-proportional or kinetic damping
  double viscosity = 0;  ///< dissipated by artificial viscosity
  double initial = 0;    ///< kinetic energy at the start, and the energy of an initial displacement
  double plastic =
      0;  ///< plastic work: work that the law has not stored; negative for a law that creates energy
  double contact = 0;   ///< stored by the penalty of contacts
  double friction = 0;  ///< dissipated by friction in contacts
  double discrete = 0;  ///< see above

  double stored() const { return kinetic + discrete + strain + hourglass + contact; }
  /// Energy that is missing (> 0) or that has been created (< 0).
  double imbalance() const {
    return initial + external - stored() - damping - viscosity - plastic - friction;
  }
};

}  // namespace femsph
