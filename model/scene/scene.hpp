#pragma once
// A scene: what a scene file contains, validated, in SI units. It says nothing of a method: element,
// formulation, kernel and spacing are chosen by a study or on the command line. "Points" are the nodes or
// particles that a method makes.

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/input/faults.hpp"
#include "model/material/material.hpp"
#include "model/scene/quantities/quantity.hpp"
#include "model/scene/shapes/shape.hpp"

namespace femsph {

using Matrix = std::array<Point, 3>;  ///< rows

struct Body {
  std::string name;
  std::shared_ptr<const Shape> shape;
  double thickness = 1.0;  ///< m, normal to the plane; 1 in 3D
  std::string material;    ///< a key of Scene::materials; empty for a rigid body
  bool rigid = false;      ///< it does not deform
  double mass = 0;         ///< kg, of a rigid body
};

/// A box parallel to the axes, in the undeformed body.
struct Region {
  Point lower{}, upper{};  ///< m
  bool contains(const Point& p, double tolerance) const;
};

/// A set of points of a body, for supports, loads and symmetry planes: those that lie on all of `sides` (in
/// 3D one side is a face, two are an edge, three a corner; in 2D two are a corner); or, with `point`, the one
/// nearest to it; or, with neither, all points of the body.
struct Place {
  std::size_t body = 0;  ///< index into Scene::bodies
  /// Names known to the body's shape: "x-", "x+", .. or a physical group of a mesh.
  std::vector<std::string> sides;
  std::optional<Point> point;  ///< m
  Source source;
  std::optional<Region> within{};  ///< restricts it to the points in this box
};

/// A factor on a load or on a prescribed velocity over time: piecewise linear, constant before the first and
/// after the last time. A step is the one point (0, 1).
struct TimeHistory {
  std::vector<double> time{0.0};  ///< s, increasing
  std::vector<double> factor{1.0};
  double at(double t) const;
};

struct Support {
  Place place;
  std::array<bool, 3> fixed{};       ///< which displacement components are fixed, or prescribed by `velocity`
  std::array<bool, 3> fixed_turn{};  ///< of a rigid body: about which axes it cannot rotate
  bool mean = false;  ///< only the weighted mean over the place is fixed, so that the place can rotate
  Point velocity{};   ///< m/s, of the fixed components, times `history`
  TimeHistory history{};
  std::string name{};  ///< of the columns of its reaction; empty: no columns
};

/// A plane side of a body that is a symmetry plane of the problem; the displacement along its normal is zero.
struct Symmetry {
  Place place;  ///< one side of the bounding box
  int axis() const { return place.sides[0][0] - 'x'; }
  bool upper() const { return place.sides[0][1] == '+'; }
  /// The coordinate of the plane along its axis, m; `shape` is that of its body.
  double position(const Shape& shape) const { return (upper() ? shape.upper() : shape.lower())[axis()]; }
};

/// A reinforcing bar parallel to an axis, perfectly bonded to its body. Its stiffness and mass are added to
/// those of the body, from which nothing is subtracted.
struct Bar {
  std::string name;
  std::size_t body = 0;
  Point from{}, to{};    ///< m, in the undeformed body
  double area = 0;       ///< m^2; in a plane scene of all bars over the thickness
  std::string material;  ///< a key of Scene::materials
  Source source{};
  int axis() const;
};

/// A total force on a place, which each discretization distributes (on a face consistently over its area); or
/// a pressure on one side, along the normal and over the area of the undeformed boundary.
struct Load {
  Place place;
  Point force{};  ///< N
  TimeHistory history;
  double pressure = 0;  ///< Pa, inward; instead of the force
};

/// An initial velocity, v(X) = s(X) (velocity + spin x (X - centre) + gradient (X - centre)). Several of one
/// body add up.
struct InitialVelocity {
  std::size_t body = 0;
  Point velocity{};   ///< m/s
  Point spin{};       ///< rad/s; in a plane about z
  Matrix gradient{};  ///< dv_i/dX_j, 1/s
  Point centre{};     ///< m
  /// s(X) = sin(2 pi (X_axis - origin) / wavelength); s = 1 without it.
  struct Wave {
    int axis;
    double wavelength, origin;  ///< m
  };
  std::optional<Wave> profile{};
  Point at(const Point& p) const;
};

/// An initial displacement, u(X) = gradient (X - centre). Supports fix the displaced positions.
struct InitialDisplacement {
  std::size_t body = 0;
  Matrix gradient{};  ///< du_i/dX_j
  Point centre{};     ///< m
  Point at(const Point& p) const;
};

/// Contact between two bodies, of which at least one is deformable; or, if tied, a bond between two
/// deformable bodies where they touch at the start.
struct Contact {
  std::string name;
  std::array<std::size_t, 2> between{};  ///< indices into Scene::bodies
  double stiffness = 1;                  ///< factor on the default penalty stiffness
  double friction = 0;                   ///< Coulomb's coefficient of friction
  Source source;
  bool tied = false;
};

/// How stress and strain are read at a point: "recovered" by the same rule for all methods
/// (model/results/recovery.hpp), or "raw" by the interpolation of the method, whose accuracy differs between
/// methods.
enum class StressReading { recovered, raw };

/// A quantity that is read at a point in every sample of a run.
struct Probe {
  std::string name;
  std::size_t body = 0;
  const Quantity* quantity = nullptr;
  Point point{};  ///< m, in the undeformed body
  StressReading reading = StressReading::recovered;
};

/// A quantity that is read at the end of a run along a line, at `count` equally spaced points from `from` to
/// `to`.
struct Section {
  std::string name;
  std::size_t body = 0;
  const Quantity* quantity = nullptr;
  Point from{}, to{};
  int count = 41;
  StressReading reading = StressReading::recovered;
};

enum class SettlingMethod { damping, kinetic };

/// The run looks for the static state: it ends when the motion has been damped out.
///   damping: mass-proportional damping with c = `rate`; without a rate c = 2 omega_1, with omega_1 estimated
///   by the Rayleigh quotient of the displacement. kinetic: all velocities are set to zero whenever the
///   kinetic energy has passed a peak.
struct Settling {
  SettlingMethod method = SettlingMethod::damping;
  /// At rest: see Settled in model/motion/README.md, whose three ratios are then below this.
  double tolerance = 1e-4;
  std::optional<double> rate;  ///< c of the damping force -c m v, 1/s
};

/// Base class of the input of an effect that has no member of its own in Scene
/// (motion/effects/catalogue.hpp).
struct EffectInput {
  virtual ~EffectInput() = default;
};

struct Scene {
  std::string title;
  std::string file;  ///< as given by the user
  std::string text;  ///< the content of the file, for the run record
  Plane plane = Plane::stress;
  bool large_motion = false;  ///< finite rotations and strains
  std::map<std::string, Material> materials;
  std::vector<Body> bodies;
  std::vector<Support> supports;
  std::vector<Symmetry> symmetries;
  std::vector<Bar> bars;
  std::vector<Load> loads;
  std::vector<InitialVelocity> initial_velocities;
  std::vector<InitialDisplacement> initial_displacements;
  std::vector<Contact> contacts;
  std::optional<Point> gravity;   ///< m/s^2
  std::optional<double> damping;  ///< rate c of mass-proportional damping, 1/s
  std::vector<Probe> probes;
  std::vector<Section> sections;
  double duration = 0;  ///< s; with settling the longest
  int samples = 400;    ///< rows of the histories over the duration
  int snapshots = 20;   ///< how often fields are written over the duration
  /// Whether fields also have recovered stress and strain, at nodes and particles.
  bool recovered_fields = false;
  std::optional<Settling> settling;
  std::map<std::string, std::shared_ptr<const EffectInput>> effect_inputs;  ///< by the name of the table
  /// Warnings of the reader: each "file:line:column: text", or a sentence.
  std::vector<std::string> warnings;

  int dim() const { return plane == Plane::none ? 3 : 2; }
  const Material& material_of(const Body& body) const { return materials.at(body.material); }
  /// Axes normal to symmetry planes: of one body, or of any.
  std::array<bool, 3> mirrored_axes(std::optional<std::size_t> body = {}) const;
  /// The supports, and after them the symmetry planes as supports that hold the displacement along their
  /// normal.
  std::vector<Support> holds() const;
  bool is_plastic() const;  ///< whether the law of a body or bar can yield
};

/// Names of what the laws of bodies and bars contain besides linear elasticity, for the list of effects.
std::vector<std::string> material_effects(const Scene& scene);

/// The law of a body, for a solver `what` that can only use linear elasticity. Throws Refusal for any other
/// law.
LinearElastic elastic_of(const Scene& scene, std::size_t body, const std::string& what);

}  // namespace femsph
