#pragma once
// The interface between the time loop and a discretization. SPH and FEM implement it; everything else is the
// same in two runs of one scene. "Points" are nodes or particles; "units" are elements (cells) or particles;
// "material points" are the quadrature points of cells, or the particles.

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

/// The layout of flat vectors: component c of point i is the entry offset + i * point_stride + c *
/// component_stride (its "slot"). FEM stores the components of a node side by side, SPH one row for each
/// component. Entries that belong to no point are padding and always 0.
struct Layout {
  std::size_t points = 0;
  int dim = 2;
  std::size_t point_stride = 1, component_stride = 0, offset = 0;
  std::size_t size = 0;  ///< length of the flat vector
  std::size_t at(std::size_t i, int c) const { return offset + i * point_stride + c * component_stride; }
};

/// A facet of a body's boundary. 2D: a segment from point 0 to point 1 with the body to its left. 3D: a
/// quadrilateral, counterclockwise seen from outside.
struct Facet {
  std::array<std::size_t, 4> points{};
};

/// The part of the area of a place that belongs to one point.
struct PointArea {
  std::size_t point;
  Point area;  ///< outward area vector, m^2; in a plane m, per unit of thickness
};

/// Stress and strain at material points, one entry each. Six components xx yy zz xy yz zx, in the axes of
/// space, with the direction normal to the plane in plane scenes. The stress is the Cauchy stress, Pa.
struct MaterialState {
  std::vector<std::array<double, 6>> stress, strain;
  std::vector<double> plastic;  ///< equivalent plastic strain; empty when the law has none
  /// The von Mises stress (Cauchy, Pa) at which each point yields at present; infinite for laws without
  /// return mapping, which do not limit it. Empty when the law has no yield stress.
  std::vector<double> flow_stress;
  std::vector<double>
      tensile_flow_stress;  ///< the same for tensile mean stress, with tension = "sign"; else empty
  std::vector<double> tensile_strength;  ///< Pa, the limit of principal stresses; empty when the law has none

  /// Sizes the three lists above for a number of points; `p` is null if the material is elastic.
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

/// The material points, for reading stress and strain at a place (results/recovery.hpp). Unit c has the
/// material points c n .. c n + n - 1.
struct MaterialUnits {
  int dim = 2;
  std::size_t points_per_unit = 1;  ///< n
  std::vector<Point> place;    ///< m, undeformed: where the strain of each material point is most accurate
  std::vector<double> volume;  ///< of each material point; a common factor does not matter
  /// J J^T of each unit, or one for all (xx yy zz xy yz zx, m^2), with J the edge vectors at the centre. A
  /// distance measured with its inverse is a number of cells.
  std::vector<std::array<double, 6>> shape;
  std::vector<double> quality;  ///< of each unit, 0 to 1: a weight for the accuracy of its strain; empty: 1
  std::size_t size() const { return place.size() / points_per_unit; }
};

/// A piece of a reinforcing bar in its present state.
struct BarPiece {
  std::size_t bar;        ///< index into Scene::bars
  Point position;         ///< m, undeformed
  double area, length;    ///< m^2, m
  double strain, stress;  ///< axial; 1, Pa
  double plastic_strain;
};

/// Why a discretization cannot continue from the present positions.
struct Trouble {
  std::string
      what;  ///< names the unit: "cell 12 has turned inside out: its volume is -0.2 times what it was"
  std::string advice;  ///< likely cause and what to try
  Point position{};    ///< m, in the deformed body
};

/// Energies of a body, J: stored by the law, stored by hourglass control, and the plastic work so far.
struct Energies {
  double strain = 0, hourglass = 0, plastic = 0;
};

/// How much stiffer a unit is than in the undeformed body.
struct Stiffening {
  double ratio = 1;  ///< upper bound of (highest frequency / that of the undeformed body)^2; infinite if a
                     ///< unit has turned inside out
  std::string unit;  ///< the stiffest: "cell 12", "particle 7"
  Point position{};  ///< m, in the deformed body
};

/// The cells of a body for output, with their points in VTK order; no cells for a body of particles that has
/// none.
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
  virtual double spacing() const = 0;         ///< smallest distance of neighbouring points along an axis, m
  virtual double wave_speed() const = 0;      ///< of the fastest wave, m/s
  virtual std::size_t bytes() const = 0;      ///< memory, without the vectors of MovingBody
  /// Warnings for the user about this discretization, a sentence each.
  virtual std::vector<std::string> warnings() const { return {}; }

  /// Computes the internal force (N) at displacement u (m) and velocity v (m/s) into f, and advances the
  /// state of the material by the step dt (s; 0 at the first call, at t = 0). All vectors are flat; padding
  /// stays 0. If has_viscosity(), the viscous force is written into `viscous`, which is null otherwise.
  virtual void internal_force(const double* u, const double* v, double dt, double* f, double* viscous) = 0;
  /// y = K x with K the elastic stiffness of the undeformed body: minus the internal force of a small
  /// displacement x. Does not change the state of the material.
  virtual void stiffness(const double* x, double* y) const = 0;
  /// y = C x: minus the viscous force at velocity x if all pairs of particles approach each other, a bound
  /// for the critical step.
  virtual void damping_matrix(const double* x, double* y) const;
  virtual bool has_viscosity() const { return false; }

  /// The energies at displacement u; for laws with a history at that of the last internal_force(). Takes a
  /// pass over the body.
  virtual Energies energies(const double* u) const = 0;
  /// Saves or restores every array that carries history from one step to the next besides u and v.
  virtual void state(Archive&) {}
  /// The worst unit at displacement u, if the method cannot continue with it: a folded cell, a particle
  /// without neighbours. Called from time to time in large motion.
  virtual std::optional<Trouble> trouble(const double*) const { return std::nullopt; }
  /// How much displacement u has stiffened the body. Nothing if the critical step does not change: the law
  /// does not stiffen, or the kernel bounds the frequencies (classic SPH with moving neighbours). Called in
  /// large motion only.
  virtual std::optional<Stiffening> stiffening(const double*) const { return std::nullopt; }
  /// The bars of the body at displacement u.
  virtual std::vector<BarPiece> bars(const double*) const { return {}; }

  /// The points of a place, sorted, each with its share of a total force on the place (sum 1). Empty if there
  /// are none.
  virtual std::vector<Weight> points_of(const Place& place) const = 0;
  /// The area of a place by points, for a pressure; a point may occur more than once. Default: the facets of
  /// boundary() with all points on the place, in equal parts to these points. Empty if there are none.
  virtual std::vector<PointArea> outward_areas(const Place& place) const;
  /// The method's own interpolation of a field of the points at p (m, undeformed); the weights sum to 1.
  virtual std::vector<Weight> interpolation(const Point& p) const = 0;

  /// The same for stress and strain: weights of material points. This is the reading "raw"; the same rule for
  /// all methods is in results/recovery.hpp.
  virtual std::vector<Weight> material_interpolation(const Point& p) const = 0;

  virtual std::size_t material_points() const = 0;
  virtual Point material_position(std::size_t point) const = 0;
  /// The volume of a material point, m^3.
  virtual double material_volume(std::size_t point) const = 0;
  /// The material points for results/recovery.hpp; empty if there is only the reading "raw".
  virtual MaterialUnits material_units() const { return {}; }
  /// The state of the listed material points at displacement u, in that order.
  virtual void material_state(const double* u, std::span<const std::size_t> points,
                              MaterialState& out) const = 0;

  virtual Topology topology() const = 0;
  /// The boundary, for contact. Default: the sides that belong to one cell of topology() only.
  virtual std::vector<Facet> boundary() const;
};

/// The sides that belong to one cell only.
std::vector<Facet> boundary_of(const Topology& topology);

}  // namespace femsph
