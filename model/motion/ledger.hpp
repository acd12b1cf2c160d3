#pragma once

namespace femsph {

/// Where the energy of a run is, J, at a whole step n.
/// kinetic is v(n-1/2) . M v(n+1/2) / 2: with it the leap-frog march conserves the sum of a linear system to round-off.
struct Ledger {
  double kinetic = 0;
  double strain = 0;      ///< stored by the law
  double hourglass = 0;   ///< stored by hourglass control
  double external = 0;    ///< work of loads and gravity
  double damping = 0;     ///< taken by mass-proportional or kinetic damping
  double viscosity = 0;   ///< taken by artificial viscosity
  double initial = 0;     ///< kinetic energy at the start, by the same measure
  double plastic = 0;     ///< work that the law has taken and does not store; negative: a law that creates energy
  double contact = 0;     ///< stored by the penalty of contacts
  double friction = 0;    ///< taken by friction in contacts

  double stored() const { return kinetic + strain + hourglass + contact; }
  /// What is missing (> 0) or has come from nowhere (< 0).
  double imbalance() const { return initial + external - stored() - damping - viscosity - plastic - friction; }
};

}  // namespace femsph
