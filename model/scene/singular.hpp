#pragma once
// Singular places: where the exact solution of a scene is infinite, so that a number that is read there does
// not converge with refinement.

#include <string>
#include <vector>

#include "model/scene/scene.hpp"

namespace femsph {

/// One such place, and the probes and sections that read there.
struct SingularPlace {
  enum class Kind {
    /// A force on a point, or on a line in space. All that is read there diverges.
    force,
    /// A support on a point, or on a line in space, that can have a reaction. Displacements of the body
    /// relative to it diverge, and so does stress there.
    hold,
    /// The end of a fixed side, or the corner where it meets a free one. Stress and strain diverge there.
    clamp,
    /// A re-entrant corner. Stress and strain diverge there.
    notch,
  } kind;
  std::size_t body;
  Source source;                       ///< of the load or support in the file; line 0: none
  std::vector<std::string> observers;  ///< names of the probes and sections that diverge
  std::string text;                    ///< one sentence for the user
  /// False for a hold: it diverges only if the support has a reaction, which is not known before the run.
  bool certain() const { return kind != Kind::hold; }
};

/// The singular places at which, or within `reach` (m) of which, a probe or section reads a diverging number.
std::vector<SingularPlace> singular_places(const Scene& scene, double reach = 0);

/// The same as warnings: "file:line:column: text", or the text alone.
std::vector<std::string> singular_warnings(const Scene& scene);

/// lambda of the stress r^(lambda - 1) at the corner where a clamped side meets a free one at a right angle:
/// the least root of sin^2(lambda pi/2) = (4 (1 - nu)^2 - lambda^2)/(3 - 4 nu) (Williams 1952), with nu/(1 +
/// nu) for nu in plane stress. It is 1, no singularity, for nu = 0.
double clamped_corner_exponent(double poisson, Plane plane);

/// By how much (m) the displacement under a force of 1 N, in its direction, grows with every halving of the
/// spacing in a plane. On a side 2 ln 2/(pi E t) (Flamant); at a right-angled corner, for a force along one
/// of its sides, (1/(pi/2 + 1) + 1/(pi/2 - 1)) ln 2/(E t) (Michell's wedge with a load along and across its
/// axis); with E/(1 - nu^2) for E in plane strain. 0 where it is not known.
double sinks_per_halving(const Scene& scene, const Place& place);

}  // namespace femsph
