#pragma once
// What the march asks of a discretization: three verbs in one call (gradient, law, divergence), the mass of
// its points, and where places and probes are. SPH and FEM implement this and nothing else differs between
// two runs of one scene.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/material/flow_stress.hpp"
#include "model/numerics/archive.hpp"
#include "model/numerics/principal.hpp"
#include "model/numerics/weight.hpp"
#include "model/scene/scene.hpp"

namespace femsph {

/// Where component c of point i of a vector field sits in its flat array: offset + i * point_stride + c *
/// component_stride. FEM keeps nodal vectors interleaved, SPH keeps one padded row per component. Slots of no
/// point are padding, always 0.
struct Layout {
  std::size_t points = 0;
  int dim = 2;
  std::size_t point_stride = 1, component_stride = 0, offset = 0;
  std::size_t size = 0;  ///< of the flat array
  std::size_t at(std::size_t i, int c) const { return offset + i * point_stride + c * component_stride; }
};

/// A piece of a body's boundary between its points. 2D: a segment 0 -> 1 with the body to its left; 3D: a
/// quadrilateral, counterclockwise seen from outside.
struct Facet {
  std::array<std::size_t, 4> points{};
};

/// Part of a place that belongs to one point.
struct PointArea {
  std::size_t point;
  Point area;  ///< outward, m^2; in the plane m, for a unit of thickness
};

/// Stress and strain at the material points (particles, or quadrature points), one entry each, six
/// components: xx yy zz xy yz zx, in the axes of space (Cauchy stress, Pa), the thickness direction of plane
/// cases included.
struct MaterialState {
  std::vector<std::array<double, 6>> stress, strain;
  std::vector<double> plastic;  ///< equivalent plastic strain; empty when the law has none
  /// Pa, Cauchy: the von Mises stress at which each point flows now; infinite where the law lets the stress
  /// pass it (without return mapping). Empty when the law has none.
  std::vector<double> flow_stress;
  std::vector<double>
      tensile_flow_stress;  ///< the same where the mean stress is tension, by the sign rule; else empty
  std::vector<double>
      tensile_strength;  ///< Pa, no principal stress above; empty when the law does not say so

  /// The three for so many points of a material; null if it is elastic.
  void resize_flow(const Plasticity* p, std::size_t points) {
    flow_stress.resize(p ? points : 0);
    tensile_flow_stress.resize(p && p->tension == TensionRule::sign ? points : 0);
    tensile_strength.resize(p && p->tension == TensionRule::principal ? points : 0);
  }
  void set_flow(std::size_t k, const FlowStress& flow) {
    if (!flow_stress.empty()) flow_stress[k] = flow.yield;
    if (!tensile_flow_stress.empty()) tensile_flow_stress[k] = flow.tensile;
    if (!tensile_strength.empty()) tensile_strength[k] = flow.strength;
  }
};

/// The material points as the reading of stress and strain sees them (recovery.hpp). Unit c (a cell, a
/// particle) has the points c n .. c n + n - 1.
struct MaterialUnits {
  int dim = 2;
  std::size_t points_per_unit = 1;  ///< n
  std::vector<Point> place;         ///< of each point, m: where its strain is most accurate; undeformed
  std::vector<double> volume;       ///< of each point; any common factor
  /// Of each unit, or one for all: J J^T, xx yy zz xy yz zx in m^2, J the edge vectors at the centre. Lengths
  /// by its inverse are counted in cells.
  std::vector<std::array<double, 6>> shape;
  std::vector<double> quality;  ///< of each unit: how far its strain is that of its place; empty: 1
  std::size_t size() const { return place.size() / points_per_unit; }
};

/// A piece of a reinforcing bar as it is now.
struct BarPiece {
  std::size_t bar;        ///< index into Scene::bars
  Point position;         ///< m, undeformed
  double area, length;    ///< m^2, m
  double strain, stress;  ///< along the bar; 1, Pa
  double plastic_strain;
};

/// Why a discretization cannot go on from where its points are now.
struct Trouble {
  std::string
      what;  ///< "cell 12 has turned inside out: its volume is -0.2 times what it was": names the unit
  std::string advice;  ///< likely cause and what to try
  Point position{};    ///< m, in the deformed body
};

/// What a body holds and has lost, J: stored by the law, stored by hourglass control, and plastic work so
/// far.
struct Energies {
  double strain = 0, hourglass = 0, plastic = 0;
};

/// How much stiffer than undeformed a unit has become.
struct Stiffening {
  double ratio = 1;  ///< bound on the square of the highest frequency over that of the undeformed body;
                     ///< infinite in a unit turned inside out
  std::string unit;  ///< "cell 12", "particle 7": the stiffest
  Point position{};  ///< m, its place in the deformed body
};

/// Cells or bare points for output: each cell lists its points in VTK order.
struct Topology {
  enum class Kind { points, quadrilaterals, hexahedra } kind = Kind::points;
  std::vector<std::array<std::size_t, 8>> cells;
};

class Discretization {
 public:
  virtual ~Discretization() = default;

  /// "corrected SPH, 16441 particles, ..": one line for the run record.
  virtual std::string describe() const = 0;
  virtual const Layout& layout() const = 0;
  virtual std::span<const double> mass() const = 0;     ///< kg, per point
  virtual Point position(std::size_t point) const = 0;  ///< m, undeformed
  /// Particles or elements: what "ns per particle- or element-step" counts.
  virtual std::size_t units() const = 0;
  virtual std::string unit_name() const = 0;  ///< "particle" or "element"
  virtual double spacing() const = 0;         ///< smallest distance d of neighbouring points along an axis, m
  virtual double wave_speed() const = 0;      ///< fastest, m/s
  virtual std::size_t bytes() const = 0;      ///< memory held, without the march's own vectors
  /// What the user should know of this discretization before believing its results, a sentence each.
  virtual std::vector<std::string> warnings() const { return {}; }

  /// Writes the internal force (N) of displacement u (m) and velocity v (m/s), both flat, into f, and
  /// advances the state of the material by the step dt (s; 0 at the first call, when nothing has moved yet).
  /// Padding stays 0. If has_viscosity(), its force goes to `viscous` instead, else that is null.
  virtual void internal_force(const double* u, const double* v, double dt, double* f, double* viscous) = 0;
  /// y = K x: minus the internal force of the elastic tangent at the undeformed state. Leaves the state of
  /// the material alone.
  virtual void stiffness(const double* x, double* y) const = 0;
  /// y = C x: minus the viscous force of velocity x when every pair is approaching (the bound the critical
  /// step needs).
  virtual void damping_matrix(const double* x, double* y) const;
  virtual bool has_viscosity() const { return false; }

  /// At displacement u; laws with a history: at that of the last internal_force(). One pass over the body.
  virtual Energies energies(const double* u) const = 0;
  /// Every array that carries history from one step to the next, beyond u and v of the march: what a run that
  /// is taken up again needs.
  virtual void state(Archive&) {}
  /// The worst unit at displacement u, if it is past what the method can follow: a folded cell, a particle
  /// without neighbours. Looked at now and then, in large motion only.
  virtual std::optional<Trouble> trouble(const double*) const { return std::nullopt; }
  /// What displacement u makes of the critical step: nothing if the law does not stiffen as it deforms (or
  /// the kernel keeps the frequencies bounded, as in classic SPH with moving neighbours). In large motion
  /// only.
  virtual std::optional<Stiffening> stiffening(const double*) const { return std::nullopt; }
  /// The bars of the body at displacement u.
  virtual std::vector<BarPiece> bars(const double*) const { return {}; }

  /// The points of a place, sorted, with the share of a unit total force that each takes (sum 1). Empty if
  /// there are none.
  virtual std::vector<Weight> points_of(const Place& place) const = 0;
  /// What a pressure on a place acts on; a point may come more than once. Unless a discretization knows
  /// better: the facets of its boundary all of whose points lie on the place, in equal parts to these. Empty
  /// if there are none.
  virtual std::vector<PointArea> outward_areas(const Place& place) const;
  /// The discretization's own interpolation of a nodal field at a point of the undeformed body; weights sum
  /// to 1.
  virtual std::vector<Weight> interpolation(const Point& p) const = 0;

  /// The same for stress and strain: weights of material points for their value at p. This is the raw
  /// reading; recovery.hpp has the one for all methods.
  virtual std::vector<Weight> material_interpolation(const Point& p) const = 0;

  virtual std::size_t material_points() const = 0;
  virtual Point material_position(std::size_t point) const = 0;
  /// Volume that each material point stands for, m^3.
  virtual double material_volume(std::size_t point) const = 0;
  /// What recovery.hpp needs, once; empty: there is the raw reading only.
  virtual MaterialUnits material_units() const { return {}; }
  /// State of the listed material points at displacement u, in their order.
  virtual void material_state(const double* u, std::span<const std::size_t> points,
                              MaterialState& out) const = 0;

  virtual Topology topology() const = 0;
  /// The boundary, for contact. Unless a discretization knows better: the sides that belong to one cell of
  /// its topology.
  virtual std::vector<Facet> boundary() const;
};

/// The sides that belong to one cell only; cells as in a Topology.
std::vector<Facet> boundary_of(const Topology& topology);

}  // namespace femsph
