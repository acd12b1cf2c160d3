#pragma once
// The one explicit loop of both solvers.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/motion/discretization.hpp"
#include "model/motion/ledger.hpp"
#include "model/numerics/array.hpp"
#include "model/results/price.hpp"

namespace femsph {

/// One discretized body and what the march keeps for it.
struct MovingBody {
  std::string name;
  std::unique_ptr<Discretization> discretization;
  AlignedVector<double> u, v, f;        ///< displacement (m), velocity at the last half step (m/s), force (N); flat
  AlignedVector<double> inverse_mass;   ///< flat, 1/kg; 0 where a support holds the component, so that it never moves
  AlignedVector<double> viscous;        ///< N; empty unless the discretization has viscosity
  struct NodalLoad {
    std::size_t slot;   ///< of the flat arrays
    double force;       ///< N at factor 1
    std::size_t load;   ///< index into Scene::loads
  };
  std::vector<NodalLoad> loads;
};

struct MarchOptions {
  double safety = 0.9;          ///< dt = safety x critical step
  std::optional<double> step;   ///< s: march with exactly this step
};

/// Called with the motion at a whole step: u and f belong to `time`, v to half a step before.
class March;
struct MarchEvents {
  std::function<void(const March&)> sample;    ///< Scene::samples times over the duration, first and last step included
  std::function<void(const March&)> snapshot;  ///< Scene::snapshots times
  std::function<void(const March&)> progress;  ///< now and then
};

/// A run that went wrong: step, time, place, likely cause and advice, in one message.
class MotionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class March {
 public:
  /// Discretizes nothing: takes the discretization of each of the scene's bodies, in order.
  /// Throws MotionError when a support or load finds no point, or when nothing can move.
  March(const Scene& scene, std::vector<std::unique_ptr<Discretization>> bodies, const MarchOptions& options);

  /// Marches to the scene's duration, or until settled. Throws MotionError.
  void run(const MarchEvents& events);

  const Scene& scene() const { return scene_; }
  const std::vector<MovingBody>& bodies() const { return bodies_; }
  long step() const { return step_; }
  double time() const { return step_ * dt_; }
  double dt() const { return dt_; }
  double critical_step() const { return critical_; }
  long planned_steps() const;
  bool settled() const { return settled_; }
  /// Energies at the current whole step, J. Costs a pass over the model: for samples, not for every step.
  Ledger ledger() const;
  /// Largest distance of sum of momentum from what external forces explain, relative; see ledger.hpp.
  const Price& price() const { return price_; }

 private:
  void forces();                ///< neighbours' gradient, law, divergence; then loads and gravity
  void kick_and_drift();        ///< v += dt f/m, u += dt v, with whichever damping is on
  bool has_settled();
  void update_damping_rate();
  void remove_kinetic_energy_at_peak();
  void check_finite() const;

  const Scene& scene_;
  std::vector<MovingBody> bodies_;
  double critical_ = 0, dt_ = 0;
  double damping_rate_ = 0;     ///< c, 1/s
  bool adaptive_damping_ = false, kinetic_damping_ = false, settled_ = false;
  long step_ = 0;
  double external_work_ = 0, damping_loss_ = 0, viscous_loss_ = 0, initial_energy_ = 0;
  double kinetic_now_ = 0, kinetic_before_ = 0;
  double still_since_ = -1;
  Price price_;
};

}  // namespace femsph
