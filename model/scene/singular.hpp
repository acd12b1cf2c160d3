#pragma once
// Places where the exact solution of a scene has no finite value, and whatever reads there: no refinement
// makes such a number settle.

#include <string>
#include <vector>

#include "model/scene/scene.hpp"

namespace femsph {

/// One place and all that reads there.
struct SingularPlace {
  enum class Kind {
    /// On a point, or on a line in space: what is read there diverges.
    force,
    /// A support on such a place that may bear a reaction: the body's displacements against it diverge, as
    /// does
    /// stress there.
    hold,
    /// Where a held side ends, or meets a free one: stress and strain diverge.
    clamp,
    /// A re-entrant corner: the same.
    notch,
  } kind;
  std::size_t body;
  Source source;                       ///< of the load or support; line 0: none
  std::vector<std::string> observers;  ///< names of probes and sections that read what diverges
  std::string text;                    ///< one sentence
  /// It is sure to diverge; otherwise (a hold) only if the support bears a reaction, which a scene alone does
  /// not tell.
  bool certain() const { return kind != Kind::hold; }
};

/// Those places at which, or within `reach` (m) of which, a probe or section reads what diverges.
std::vector<SingularPlace> singular_places(const Scene& scene, double reach = 0);

/// The same for the user: "file:line:column: text", or the text alone.
std::vector<std::string> singular_warnings(const Scene& scene);

/// The exponent of the stress, r^(lambda - 1), where a clamped side meets a free one at a right angle: the
/// least root of sin^2(lambda pi/2) = (4 (1 - nu)^2 - lambda^2)/(3 - 4 nu) (Williams 1952); plane stress
/// takes nu/(1 + nu). 1 for nu = 0: no singularity.
double clamped_corner_exponent(double poisson, Plane plane);

/// In a plane: what the displacement under a force of 1 N, along the force, gains with every halving of the
/// spacing, m. On a side it is 2 ln 2/(pi E t) (Flamant); at a right-angled corner, along one of its sides,
/// (1/(pi/2 + 1) + 1/(pi/2 - 1)) ln 2/(E t) (Michell's wedge loaded along and across its axis); E/(1 - nu^2)
/// for E in plane strain. 0 elsewhere: not known.
double sinks_per_halving(const Scene& scene, const Place& place);

}  // namespace femsph
