#pragma once
// The momentum of all bodies, and the balance of forces: loads, reactions and inertia.

#include "model/motion/reactions.hpp"

namespace femsph {

/// The momentum of all bodies, rigid ones included, at a whole step; angular momentum about the origin. In
/// small motion with the undeformed positions of the points, about which internal moments balance.
struct Momentum {
  Point linear{};   ///< kg m/s
  Point angular{};  ///< kg m^2/s; in a plane scene only z
};
Momentum momentum(const March& march);

/// |rate of momentum - (loads + weight + reactions + damping)| over the sum of the magnitudes of both, at the
/// present step. It is round-off unless internal forces, contacts or bonds have a resultant, or an external
/// force is missing. The loads are the totals of the scene; the reactions are those of all supports. Left out
/// are the components normal to symmetry planes, where the mirrored half exerts a force as well, and the
/// moments that contain them.
struct Balance {
  double force = 0;
  double moment =
      0;  ///< about the origin; 0 in small motion with contact, whose forces act at displaced positions
};
Balance balance(const March& march,
                const std::vector<Reaction>& reactions);  ///< from all_reactions(march)
inline Balance balance(const March& march) { return balance(march, all_reactions(march)); }

}  // namespace femsph
