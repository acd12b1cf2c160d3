#pragma once
// Rigid bodies. They have no discretization: contact uses their shape.

#include <array>
#include <string>
#include <vector>

#include "model/numerics/archive.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/shapes/rigid_form.hpp"

namespace femsph {

/// The closest-point projection of a point onto a piece of a surface: a facet, or a side of a rigid shape.
struct Projection {
  std::array<double, 4> share{};  ///< shape functions of the facet at the foot
  Point foot{}, normal{};         ///< the projection, m; the outward unit normal there
  double gap = 0;                 ///< distance along the normal, m; negative inside of the body
  double beyond = 0;              ///< how far the foot lies outside of the piece, m
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
  Point moved{}, velocity{};  ///< displacement of the centre, m; its velocity at the last half step, m/s
  Point spin{};  ///< angular momentum about the centre at the last half step, in the axes of space, kg m^2/s
  Point force{}, moment{};  ///< resultant at the centre, N and N m
  Point gravity{};          ///< m/s^2
  std::array<Point, 3> axes{
      Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};  ///< the axes of the shape, in space
  double angle = 0;                                     ///< rotation in a plane scene, rad
  std::array<bool, 3> held{}, held_turn{};

  Point centre() const { return {start[0] + moved[0], start[1] + moved[1], start[2] + moved[2]}; }
  Point rate() const { return rate_of(spin); }  ///< angular velocity, rad/s, in the axes of space
  Point rate_of(const Point& spin) const;
  Point velocity_at(const Point& x) const;
  void push(const Point& x, const Point& f);  ///< adds a force f at x
  double reach() const;    ///< upper bound of the distance of its points from the centre, m
  double surface() const;  ///< surface area, m^2; perimeter in a plane, m
  /// Lower bound of the effective mass (kg) against a force anywhere on the body: 1 / (1/M + r^2/I); infinite
  /// if it is fixed.
  double least_mass() const;
  /// The number of sides of its shape: those of a box, one of a disc or sphere.
  int sides() const;
  Projection project(int side, const Point& x) const;

  /// Sets the force to the weight, and the moment to 0.
  void begin_forces();
  /// The leap-frog: kick() changes velocity and angular momentum, drift() the position. keep and push: see
  /// Leap.
  void kick(double keep, double push);
  void drift(double dt);
  /// Changes velocity and angular momentum from those at the start to those half a step before (see
  /// March::start_velocities).
  void start_from(double keep, double push);
  void state(Archive& archive);
  /// The velocity of the centre and the angular momentum about it at the whole step: means of the half steps
  /// before and after.
  std::array<Point, 2> half_way(double keep, double push) const;
  /// m |v+ - v-|^2, and the same of the rotation, J.
  double energy_of_kick(double keep, double push) const;
  /// m v- . v + omega- . L (J) with v = before v- + after v+, and the angular momentum L likewise: twice a
  /// kinetic energy.
  double product(double keep, double push, double before, double after) const;

 private:
  const RigidForm& form() const;
};

}  // namespace femsph
