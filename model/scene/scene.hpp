#pragma once
// The case, before any discretization: what a scene file says, validated, in SI units.
// No solver word belongs here: element, formulation, kernel and spacing are chosen by a study or on the
// command line.

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
  double thickness = 1.0;  ///< m, out of plane; 1 in 3D
  std::string material;    ///< a key of Scene::materials; empty for a rigid body
  bool rigid = false;      ///< moves and turns as a whole
  double mass = 0;         ///< kg, of a rigid body
};

/// An axis-parallel region of the undeformed body.
struct Region {
  Point lower{}, upper{};  ///< m
  bool contains(const Point& p, double tolerance) const;
};

/// Part of a body: the points of its boundary that lie on all of `sides` (one side: a face; two: an edge in
/// 3D, a corner in 2D; three: a corner in 3D); or, with `point`, the discretization point nearest to it; or,
/// with neither, the whole body.
struct Place {
  std::size_t body = 0;  ///< index into Scene::bodies
  /// Names known to the body's shape: "x-", "x+", .. or a physical group of a mesh.
  std::vector<std::string> sides;
  std::optional<Point> point;  ///< m
  Source source;
  std::optional<Region> within{};  ///< of these, only the points in here
};

/// How a load or a moved support grows in time: a piecewise linear factor, held constant beyond its ends. A
/// step is one point (0, 1).
struct TimeHistory {
  std::vector<double> time{0.0};  ///< s, increasing
  std::vector<double> factor{1.0};
  double at(double t) const;
};

struct Support {
  Place place;
  std::array<bool, 3> fixed{};       ///< which displacement components are held where they start
  std::array<bool, 3> fixed_turn{};  ///< of a rigid body: about which axes it cannot turn
  bool mean = false;  ///< only the weighted mean over the place is held, so that the place may turn
  Point velocity{};   ///< m/s: the held components move so, times `history`
  TimeHistory history{};
  std::string name{};  ///< its reaction is in the history under this; empty: not asked for
};

/// A plane side of a body beyond which the body goes on, mirrored; its normal displacement is zero.
struct Symmetry {
  Place place;  ///< one side of the bounding box
  int axis() const { return place.sides[0][0] - 'x'; }
  bool upper() const { return place.sides[0][1] == '+'; }
};

/// Reinforcement along one axis, perfectly bonded to its body. It adds its stiffness and its mass to the
/// body, which keeps its own.
struct Bar {
  std::string name;
  std::size_t body = 0;
  Point from{}, to{};    ///< m, in the undeformed body
  double area = 0;       ///< m^2, of all bars over the thickness of a plane body; of one in space
  std::string material;  ///< a key of Scene::materials
  Source source{};
  int axis() const;
};

/// A force on a place, given as its total; each discretization shares it out (consistently over a face's
/// area). Or a pressure on one side, along the normal and over the area that the boundary has there at the
/// start.
struct Load {
  Place place;
  Point force{};  ///< N
  TimeHistory history;
  double pressure = 0;  ///< Pa, inward; instead of the force
};

/// Motion of a body at the start, v(X) = s(X) (velocity + spin x (X - centre) + gradient (X - centre)).
/// Several of one body add up.
struct InitialVelocity {
  std::size_t body = 0;
  Point velocity{};   ///< m/s
  Point spin{};       ///< rad/s; in a plane about z
  Matrix gradient{};  ///< dv_i/dX_j, 1/s
  Point centre{};     ///< m
  /// s(X) = sin(2 pi (X_axis - origin) / wavelength); without one s = 1.
  struct Wave {
    int axis;
    double wavelength, origin;  ///< m
  };
  std::optional<Wave> profile{};
  Point at(const Point& p) const;
};

/// Displacement at the start, u(X) = gradient (X - centre). Supports hold it.
struct InitialDisplacement {
  std::size_t body = 0;
  Matrix gradient{};  ///< du_i/dX_j
  Point centre{};     ///< m
  Point at(const Point& p) const;
};

/// Two bodies, one of them deformable at least, that press on each other where they touch; or, tied, two that
/// deform and are bonded where they touch at the start.
struct Contact {
  std::string name;
  std::array<std::size_t, 2> between{};  ///< indices into Scene::bodies
  double stiffness = 1;                  ///< factor on the default penalty
  double friction = 0;                   ///< Coulomb's coefficient
  Source source;
  bool tied = false;
};

/// How stress and strain are read at a point: by the one rule of model/results/recovery.hpp, or by the
/// discretization's own interpolation of its material points, whose order at a surface is the method's own
/// affair.
enum class StressReading { recovered, raw };

/// Something read at a point in every sample of a run.
struct Probe {
  std::string name;
  std::size_t body = 0;
  const Quantity* quantity = nullptr;
  Point point{};  ///< m, in the undeformed body
  StressReading reading = StressReading::recovered;
};

/// The same along a straight line, at `count` equally spaced points from `from` to `to`.
struct Section {
  std::string name;
  std::size_t body = 0;
  const Quantity* quantity = nullptr;
  Point from{}, to{};
  int count = 41;
  StressReading reading = StressReading::recovered;
};

enum class SettlingMethod { damping, kinetic };

/// Ask for the static state: march with damping until the motion has died out.
///   damping: mass-proportional, c = 2 omega_1 unless `rate` says otherwise (omega_1 from the Rayleigh
///   quotient of the motion itself); kinetic: no damping; velocities are set to zero at every peak of the
///   kinetic energy.
struct Settling {
  SettlingMethod method = SettlingMethod::damping;
  /// Settled when the amplitude of what still moves is below this share of the displacement.
  double tolerance = 1e-4;
  std::optional<double> rate;  ///< c, 1/s: damping force = c m v
};

/// What an effect reads from a table of its own, if the scene has no member for it (motion/effects).
struct EffectInput {
  virtual ~EffectInput() = default;
};

struct Scene {
  std::string title;
  std::string file;  ///< as given by the user
  std::string text;  ///< the file's content, for the run record
  Plane plane = Plane::stress;
  bool large_motion = false;  ///< finite rotation of the axes of the material
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
  std::optional<double> damping;  ///< mass-proportional, c in 1/s
  std::vector<Probe> probes;
  std::vector<Section> sections;
  double duration = 0;  ///< s; with settling: at most this long
  int samples = 400;    ///< rows of the histories over the duration
  int snapshots = 20;   ///< fields written over the duration
  /// Fields hold stress and strain by the one rule at nodes and particles too.
  bool recovered_fields = false;
  std::optional<Settling> settling;
  std::map<std::string, std::shared_ptr<const EffectInput>> effect_inputs;  ///< by the name of their table
  /// What the reader wants said: each "file:line:column: text", or a sentence.
  std::vector<std::string> warnings;

  int dim() const { return plane == Plane::none ? 3 : 2; }
  const Material& material_of(const Body& body) const { return materials.at(body.material); }
  /// The supports, and the symmetry planes as what they hold: their normal component.
  std::vector<Support> holds() const;
  bool is_plastic() const;  ///< some body's or bar's material is
};

/// What the materials of its bodies and bars ask for beyond linear elasticity, by name.
std::vector<std::string> material_effects(const Scene& scene);

/// The elastic law of a body, for a solver `what` that knows no other. Throws std::runtime_error when its
/// material is plastic.
LinearElastic elastic_of(const Scene& scene, std::size_t body, const std::string& what);

}  // namespace femsph
