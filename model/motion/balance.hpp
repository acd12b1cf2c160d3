#pragma once
// Momentum of all bodies, and whether forces, reactions and inertia add up to nothing.

#include "model/motion/reactions.hpp"

namespace femsph {

/// Of all bodies, rigid ones included, at a whole step; angular momentum about the origin. In small motion
/// points are where they began, for that is what moments are kept about.
struct Momentum {
  Point linear{};   ///< kg m/s
  Point angular{};  ///< kg m^2/s; in a plane z only
};
Momentum momentum(const March& march);

/// |rate of momentum - (loads + weight + reactions + damping)| over the sum of the magnitudes of both, now:
/// what the internal forces, contacts and bonds give that nothing outside has given, or an outside force that
/// is not in the account. The loads are the totals that the scene gives, and the reactions those of every
/// support, each with its share. Round-off in a sound run, with one exception: along the normal of a symmetry
/// plane the other half pushes as well, and that component is left out, with the moments that it enters.
struct Balance {
  double force = 0;
  double moment = 0;  ///< about the origin; 0 in small motion with contact, where forces act where bodies are
                      ///< and moments are taken where they were
};
Balance balance(const March& march,
                const std::vector<Reaction>& reactions);  ///< all_reactions() of this march
inline Balance balance(const March& march) { return balance(march, all_reactions(march)); }

}  // namespace femsph
