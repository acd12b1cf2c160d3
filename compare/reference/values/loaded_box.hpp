#pragma once
// The data that the theories of bars and of cantilevers take from a scene: one box that is held on its face
// x- and loaded on its face x+. SI units, signs as in the scene.

#include <functional>
#include <limits>
#include <string>

#include "compare/reference/values/theory_value.hpp"

namespace femsph::compare {

struct LoadedBox {
  Point origin;                  ///< lower corner, m
  double length, height, width;  ///< along x, along y, and along z (2D: the thickness), m
  double young;     ///< E, Pa; in plane strain E/(1 - nu^2), as the strain across the width is held at zero
  double shear;     ///< G = E/(2 (1 + nu)), Pa, with E of the material
  double density;   ///< kg/m^3
  Point force;      ///< sum of the loads at the end of their time histories, N
  bool step;        ///< the loads act in full from the start
  bool damped;      ///< by [damping] or [settling]: no theory of histories, frequencies and peaks then
  double duration;  ///< of the scene, s
  double yield = std::numeric_limits<double>::infinity();  ///< Pa: elastic up to here
  double area() const { return height * width; }
  double inertia() const { return width * height * height * height / 12; }
};

/// The box of a scene. `theory`, "bar" or "cantilever", is named in messages. Throws std::runtime_error with
/// one sentence if the scene is not of this kind: another body, shape or support, reinforcing bars, a plane
/// of symmetry, or loads with a moment about the middle of x+.
LoadedBox loaded_box(const Scene& scene, const std::string& theory);

/// A theory value of the box: x from the held face, y from the middle of the height, m; time, s.
using BoxValue = std::function<double(const LoadedBox&, double x, double y, double time)>;

/// Makes the values of one solution: `box_of` gives the box of a scene, or throws.
struct BoxTheory {
  LoadedBox (*box_of)(const Scene&);
  Theory operator()(const char* name, const char* unit, const char* formula, Theory::Depends depends,
                    BoxValue value) const;
};

/// Throws std::runtime_error: "THEORY theory needs one box, held on x- .., but WHY".
[[noreturn]] void refuse_theory(const std::string& theory, const std::string& why);
/// Whether the force is not zero and has no other component than this one.
bool only_along(const Point& force, int axis);
/// Throws std::runtime_error if the magnitude of the stress (Pa) is above the yield stress.
void need_elastic(const LoadedBox& box, double stress, const std::string& theory);
/// Throws std::runtime_error if the scene has damping.
void need_undamped(const LoadedBox& box, const std::string& theory);
/// Throws std::runtime_error unless the load is a step, the scene has no damping, and twice the static stress
/// (Pa), the largest stress under a step load, is at most the yield stress.
void need_step(const LoadedBox& box, double static_stress, const std::string& theory);

/// Why no theory of one box holds for a scene; empty if there is no such reason. `moving`: an initial
/// velocity is allowed.
std::string not_one_box(const Scene& scene, bool moving);
/// Whether the place lies on this side, alone or with others.
bool names_side(const Place& place, const std::string& side);

}  // namespace femsph::compare
