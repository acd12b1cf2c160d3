#pragma once
// The state of a run, as effects see it: deformable bodies, rigid bodies and time. + // + // A "point" is a
// node or a particle. Vectors are flat (see Layout); a "slot" is an index into them, that is, one
// displacement component of one point. A component is "held" if a support or a symmetry plane fixes it or
// prescribes its motion.

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "model/motion/bodies/discretization.hpp"
#include "model/motion/bodies/price.hpp"
#include "model/motion/bodies/rigid.hpp"
#include "model/numerics/array.hpp"

namespace femsph {

/// One deformable body.
struct MovingBody {
  std::string name;
  std::size_t index = 0;  ///< into Scene::bodies
  std::unique_ptr<Discretization> discretization;
  AlignedVector<double> u;  ///< displacement, m, at the present whole step n
  AlignedVector<double> v;  ///< velocity, m/s, at n - 1/2
  AlignedVector<double> f;  ///< force, N, at n: the internal force and those of the effects
  /// 1/kg; 0 for held components, so that no force moves them.
  AlignedVector<double> inverse_mass;
  AlignedVector<double> viscous;   ///< viscous force, N, at n; empty unless the discretization has viscosity
  AlignedVector<double> mass;      ///< kg; empty in runs without damping and settling
  AlignedVector<double> internal;  ///< internal and viscous force alone, N; only while a sample is taken
  /// A held component whose mass matters: its support prescribes a velocity, or stops it at t = 0 (then
  /// `velocity` is 0). It is treated as a free component on which the reaction acts that gives it the
  /// prescribed motion. Sorted by slot.
  struct Driven {
    std::size_t slot;
    double velocity;               ///< m/s, at a factor of 1 of the history
    std::size_t support;           ///< index into Scene::supports; meaningless where the velocity is 0
    double mass;                   ///< kg
    double start;                  ///< m/s: the initial velocity of the point, from [[initial]]
    double before = 0, after = 0;  ///< m/s, at n - 1/2 and n + 1/2
    double reaction = 0;           ///< N, at n
  };
  std::vector<Driven> driven;
  /// A held component and one support of it, as an index into Scene::holds(). One entry for each support of
  /// the component. Sorted.
  struct Held {
    std::size_t point;
    int component;
    std::size_t hold;
    auto operator<=>(const Held&) const = default;
  };
  std::vector<Held> held;
  /// Slots that take part in a constraint; none may take part in two.
  std::vector<std::size_t> constrained;

  /// The force (N) on a slot, viscosity included.
  double force(std::size_t slot) const { return viscous.empty() ? f[slot] : f[slot] + viscous[slot]; }
};

/// The velocity update of the leap-frog over a time tau with mass-proportional damping of rate c: v+ = keep
/// v- + push f/m, keep = (1 - c tau/2) / (1 + c tau/2), push = tau / (1 + c tau/2).
struct Leap {
  double keep, push;
};

/// The point and component of a slot.
std::pair<std::size_t, int> component_of(const Layout& at, std::size_t slot);

/// |x| + |y| + |z|
inline double sum_of_magnitudes(const Point& p) { return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]); }

struct Motion {
  const Scene& scene;
  std::vector<MovingBody> bodies{};  ///< the deformable ones
  std::vector<RigidBody> rigid{};
  long step = 0;            ///< n, the present whole step
  double dt = 0;            ///< s, the step from n - 1 to n
  double next_dt = 0;       ///< s, the step from n to n + 1
  double since_time = 0;    ///< s: the time at which dt last changed
  long since_step = 0;      ///< the step number at that time
  double damping_rate = 0;  ///< c, 1/s, of mass-proportional damping
  mutable Price price{};    ///< cost of the run so far

  double time_of(long n) const { return since_time + double(n - since_step) * dt; }
  double time() const { return time_of(step); }
  Leap leap(double tau) const {
    return {(1 - 0.5 * damping_rate * tau) / (1 + 0.5 * damping_rate * tau),
            tau / (1 + 0.5 * damping_rate * tau)};
  }
  /// The points of a place. Throws MotionError if there are none; `what` is what acts there ("load"), for the
  /// message.
  std::vector<Weight> points_of(const MovingBody& body, const Place& place, const char* what) const;
};

/// A run that failed. The message has step, time, place, likely cause and advice.
class MotionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A run that one of the checks has stopped after its start.
class Stopped : public MotionError {
 public:
  enum class Watch { not_a_number, energy, step, unit, contact };
  Stopped(Watch watch, const std::string& message) : MotionError(message), watch(watch) {}
  Watch watch;
};

}  // namespace femsph
