#pragma once

namespace femsph {

/// Where the energy of a run is, J, at a whole step n.
/// kinetic is 1/2 v . M v with v = (v(n-1/2) + v(n+1/2)) / 2, as anybody would take it. What the leap-frog
/// march conserves to round-off in a linear system has v(n-1/2) . M v(n+1/2) / 2 in its place; `discrete` is
/// the difference of the two, -dt^2/8 a . M a, less what it was at the start. It is below 0 when forces are
/// larger than at the start, vanishes with dt^2, and is no energy of the bodies.
struct Ledger {
  double kinetic = 0;
  double strain = 0;     ///< stored by the law
  double hourglass = 0;  ///< stored by hourglass control
  double external = 0;   ///< work of loads, gravity and moved supports
  double damping = 0;    ///< taken by mass-proportional or kinetic damping
  double viscosity = 0;  ///< taken by artificial viscosity
  double initial = 0;    ///< kinetic energy at the start, and what an initial displacement has stored
  double plastic =
      0;  ///< work that the law has taken and does not store; negative: a law that creates energy
  double contact = 0;   ///< stored by the penalty of contacts
  double friction = 0;  ///< taken by friction in contacts
  double discrete = 0;  ///< of the measure, see above

  double stored() const { return kinetic + discrete + strain + hourglass + contact; }
  /// What is missing (> 0) or has come from nowhere (< 0).
  double imbalance() const {
    return initial + external - stored() - damping - viscosity - plastic - friction;
  }
};

}  // namespace femsph
