#pragma once
// Bodies that move and turn as a whole. A rigid body is no discretization: its surface is its shape, and
// contact asks that.

#include <array>
#include <string>
#include <vector>

#include "model/numerics/archive.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/shapes/rigid_form.hpp"

namespace femsph {

/// Where a point stands to a piece of a surface: a facet, or a side of a rigid shape.
struct Stand {
  std::array<double, 4> share{};  ///< facets: shape functions at the foot
  Point foot{}, normal{};         ///< nearest point of the piece; outward there
  double gap = 0;                 ///< m; below 0: inside
  double beyond = 0;              ///< m: how far the foot lies beyond the piece's edge
};

struct RigidBody {
  RigidBody(const Scene& scene, std::size_t index);

  std::string name;
  std::size_t index;  ///< into Scene::bodies
  int dim;
  std::shared_ptr<const Shape> shape;
  double mass;                ///< kg
  Point inertia{};            ///< about the axes of the shape, kg m^2
  Point start{};              ///< centre at the start, m
  Point moved{}, velocity{};  ///< displacement of the centre; its velocity at the last half step
  Point spin{};               ///< angular momentum about the centre at the last half step, in space, kg m^2/s
  Point force{}, moment{};    ///< on the centre, N and N m
  Point gravity{};            ///< m/s^2
  std::array<Point, 3> axes{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};  ///< of the shape, in space
  double angle = 0;                                                           ///< in a plane, rad
  std::array<bool, 3> held{}, held_turn{};

  Point centre() const { return {start[0] + moved[0], start[1] + moved[1], start[2] + moved[2]}; }
  Point rate() const { return rate_of(spin); }  ///< angular velocity, rad/s
  Point rate_of(const Point& spin) const;
  Point velocity_at(const Point& x) const;
  void push(const Point& x, const Point& f);  ///< adds a force f at x
  double reach() const;                       ///< no point of the body is farther from its centre, m
  double surface() const;                     ///< area (perimeter in 2D), m^(dim-1)
  /// Mass that the body opposes at least to a push anywhere on it: 1/M + r^2/I, kg; infinite if it is fixed.
  double least_mass() const;
  /// Of the shape: those of a box, or one of a ball.
  int sides() const;
  Stand stand(int side, const Point& x) const;

  /// Its weight, in place of what was there.
  void begin_forces();
  /// Leap-frog: velocity and spin by the force, then the place by the velocity. keep and push: see
  /// Leap.
  void kick(double keep, double push);
  void drift(double dt);
  /// From velocity and spin at the start to those half a step before (see March::start_velocities).
  void start_from(double keep, double push);
  void state(Archive& archive);
  /// Velocity of the centre and angular momentum about it at the whole step: the means of the half steps
  /// around it.
  std::array<Point, 2> half_way(double keep, double push) const;
  /// m |v+ - v-|^2, and of the turning likewise.
  double energy_of_kick(double keep, double push) const;
  /// m v-.v + omega-.L with v = before v- + after v+, and L likewise: twice a kinetic energy.
  double product(double keep, double push, double before, double after) const;

 private:
  const RigidForm& form() const;
};

}  // namespace femsph
