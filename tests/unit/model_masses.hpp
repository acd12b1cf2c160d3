#pragma once
// Bodies of one or two masses on springs, whose motion is known, and their scene.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/motion/march.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/shapes/box.hpp"
#include "model_results_fake.hpp"

namespace femsph::test {

/// One mass at (0.5, 0.25), in a plane; derived classes give it its springs.
class OneMass : public FakeBody {
 public:
  explicit OneMass(double mass) : mass_(1, mass) {
    layout_ = {1, 2, 2, 1, 0, 2};
    points_ = {{0.5, 0.25, 0}};
  }
  std::span<const double> mass() const override { return mass_; }
  std::size_t units() const override { return 1; }
  std::vector<Weight> points_of(const Place&) const override { return {{0, 1.0}}; }
  std::vector<Weight> interpolation(const Point&) const override { return {{0, 1.0}}; }

 private:
  std::vector<double> mass_;
};

/// One body "body", whose shape and material nothing reads, for `duration` seconds.
inline Scene scene_of_masses(double duration) {
  Scene s;
  s.materials["m"] = Material{"m", 1, 0, 1};
  s.bodies.push_back({"body", std::make_shared<Box>(2, Point{}, Point{1, 1, 0}), 1, "m"});
  s.duration = duration;
  return s;
}

/// The same in flight, in large motion.
inline Scene flying_masses(double duration, const Point& velocity) {
  Scene s = scene_of_masses(duration);
  InitialVelocity start;
  start.velocity = velocity;
  s.initial_velocities.push_back(start);
  s.large_motion = true;
  return s;
}

/// What a march takes: a list, of this one body.
inline std::vector<std::unique_ptr<Discretization>> bodies_of(std::unique_ptr<Discretization> body) {
  std::vector<std::unique_ptr<Discretization>> v;
  v.push_back(std::move(body));
  return v;
}

/// Why a watch has stopped a march; `watch` is empty if none has.
struct Stop {
  std::optional<Stopped::Watch> watch;
  std::string message;
};
inline Stop run_until_stopped(March& march, const MarchEvents& events) {
  try {
    march.run(events);
  } catch (const Stopped& stop) {
    return {stop.watch, stop.what()};
  }
  return {};
}

}  // namespace femsph::test
