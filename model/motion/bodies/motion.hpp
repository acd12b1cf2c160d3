#pragma once
// What a march moves, as its effects see it: bodies, rigid bodies and the clock.

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

/// One discretized body and what the march keeps for it. Vectors are flat (see Layout).
struct MovingBody {
  std::string name;
  std::size_t index = 0;  ///< into Scene::bodies
  std::unique_ptr<Discretization> discretization;
  AlignedVector<double> u;  ///< displacement, m, at the whole step of now
  AlignedVector<double> v;  ///< velocity, m/s, at the half step before
  AlignedVector<double> f;  ///< N, now: the internal force, and all that effects have added
  /// 1/kg; 0 where a support holds the component, so that it never moves.
  AlignedVector<double> inverse_mass;
  AlignedVector<double> viscous;   ///< N, now; empty unless the discretization has viscosity
  AlignedVector<double> mass;      ///< kg; empty unless settling or damping needs it
  AlignedVector<double> internal;  ///< N: internal and viscous force alone; only while a sample is taken
  /// A held component whose points have inertia in the march: one that moves as its support says, or that its
  /// support stops at t = 0 (velocity 0). It is a free component under its reaction, and the reaction is what
  /// makes it follow. Sorted by slot.
  struct Driven {
    std::size_t slot;
    double velocity;               ///< m/s at factor 1
    std::size_t support;           ///< index into Scene::supports; any where the velocity is 0
    double mass;                   ///< kg
    double start;                  ///< m/s: what [[initial]] gives this point at t = 0
    double before = 0, after = 0;  ///< m/s, at the half steps before and after now
    double reaction = 0;           ///< N, now
  };
  std::vector<Driven> driven;
  /// A held component and one of those that hold it (an index into Scene::holds()); once for each of them.
  /// Sorted.
  struct Held {
    std::size_t point;
    int component;
    std::size_t hold;
    auto operator<=>(const Held&) const = default;
  };
  std::vector<Held> held;
  /// Slots that a constraint moves together with others: no second constraint may take them.
  std::vector<std::size_t> constrained;

  /// Force (N) on a slot, viscosity included.
  double force(std::size_t slot) const { return viscous.empty() ? f[slot] : f[slot] + viscous[slot]; }
};

/// The leap-frog over a time tau, with damping of rate c: v+ = keep v- + push f/m,
/// keep = (1 - c tau/2) / (1 + c tau/2), push = tau / (1 + c tau/2).
struct Leap {
  double keep, push;
};

/// The point and component of a slot.
std::pair<std::size_t, int> component_of(const Layout& at, std::size_t slot);

/// |x| + |y| + |z|
inline double sum_of_magnitudes(const Point& p) { return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]); }

struct Motion {
  const Scene& scene;
  std::vector<MovingBody> bodies{};  ///< those that deform
  std::vector<RigidBody> rigid{};
  long step = 0;            ///< now is the whole step `step`
  double dt = 0;            ///< s, of the step that led here
  double next_dt = 0;       ///< s, of the step that begins here
  double since_time = 0;    ///< s: when the step last changed
  long since_step = 0;      ///< and at which step
  double damping_rate = 0;  ///< c, 1/s
  mutable Price price{};    ///< what the run has cost so far

  double time_of(long n) const { return since_time + double(n - since_step) * dt; }
  double time() const { return time_of(step); }
  Leap leap(double tau) const {
    return {(1 - 0.5 * damping_rate * tau) / (1 + 0.5 * damping_rate * tau),
            tau / (1 + 0.5 * damping_rate * tau)};
  }
  /// The points of a place. Throws MotionError if there are none; `what` acts there.
  std::vector<Weight> points_of(const MovingBody& body, const Place& place, const char* what) const;
};

/// A run that went wrong: step, time, place, likely cause and advice, in one message.
class MotionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A march that one of its watches stopped: it was sound when it began.
class Stopped : public MotionError {
 public:
  enum class Watch { not_a_number, energy, step, unit, contact };
  Stopped(Watch watch, const std::string& message) : MotionError(message), watch(watch) {}
  Watch watch;
};

}  // namespace femsph
