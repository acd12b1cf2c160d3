#pragma once
// The explicit time integration ("march") of both solvers: central differences, or leap-frog, with lumped
// masses.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/motion/bodies/ledger.hpp"
#include "model/motion/bodies/motion.hpp"
#include "model/motion/effects/effect.hpp"

namespace femsph {

struct MarchOptions {
  double safety = 0.9;         ///< dt = safety x critical step
  std::optional<double> step;  ///< s: use exactly this step
};

class March;

/// What the caller does during a run. At each call u and f belong to March::time(), and v to half a step
/// before.
struct MarchEvents {
  /// Scene::samples times over the duration; also at the first and at the last step.
  std::function<void(const March&)> sample;
  std::function<void(const March&)> snapshot;  ///< Scene::snapshots times
  std::function<void(const March&)> progress;  ///< every 25 to 1000 steps
  /// After every step, when March::state() can be saved; may throw to end the run.
  std::function<void(March&)> between;
};

class March {
 public:
  /// `bodies`: the discretization of each deformable body, in the order of the scene. `scene` must outlive
  /// the march. Throws MotionError if a support or load finds no point, if nothing can move, or if a given
  /// step is above the critical one.
  March(const Scene& scene, std::vector<std::unique_ptr<Discretization>> bodies, const MarchOptions& options);
  March(const March&) = delete;

  /// Runs to the end of the scene's duration, or until the bodies have settled. Throws MotionError.
  void run(const MarchEvents& events);

  const Scene& scene() const { return motion_.scene; }
  const Motion& motion() const { return motion_; }
  const std::vector<MovingBody>& bodies() const { return motion_.bodies; }  ///< the deformable bodies
  const MovingBody& body(std::size_t index) const;  ///< a deformable body, by its index in Scene::bodies
  const std::vector<RigidBody>& rigid_bodies() const { return motion_.rigid; }
  const EffectList& effects() const { return effects_; }
  /// The present force (N) of the first body of each contact on the second, in the order of the scene.
  std::vector<Point> contact_forces() const;
  long step() const { return motion_.step; }
  double time() const { return motion_.time(); }
  double dt() const { return motion_.dt; }
  double smallest_step() const { return smallest_step_; }  ///< s, so far
  long step_changes() const { return step_changes_; }
  bool follows_deformation() const { return follows_; }  ///< whether the step is adapted to the deformation
  double critical_step() const { return critical_; }     ///< s, of the undeformed bodies, contact included
  double critical_step_without_contact() const { return critical_alone_; }
  bool bounded_by_effects() const {
    return !effects_.with(Hook::add_springs).empty();
  }  ///< whether an effect bounds the step
  long planned_steps() const;
  bool settled() const { return settled_; }
  /// The present reaction (N) on a held component, of all its supports together. `slot`: see MovingBody.
  double reaction(const MovingBody& body, std::size_t slot) const;
  /// The velocity (m/s) of a component at the present whole step: the mean of those half a step before and
  /// after.
  double velocity(const MovingBody& body, std::size_t slot) const;
  Point velocity(const RigidBody& body) const;  ///< of its centre
  Point spin(const RigidBody& body) const;      ///< its angular momentum about the centre, kg m^2/s
  /// Warnings for the user, a sentence each: about the scene, its discretizations and the run so far. Those
  /// known before the first step come first.
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// Saves or restores everything that a resumed run needs. Only between two steps (MarchEvents::between).
  void state(Archive& archive);
  /// Call it before run() to keep, in memory, the state of the last check that found no fault. Does nothing
  /// in small elastic motion without contact, which is bounded below the critical step.
  void keep_good_states();
  /// Goes back to that state, to write its fields; false if there is none. The run cannot be continued from
  /// there.
  bool return_to_good_state();
  /// The energies (J) at the present whole step. Takes a pass over the model: for samples, not for every
  /// step.
  Ledger ledger() const;
  /// |sum of internal forces| / sum of |internal forces| at the present whole step, the largest of all
  /// bodies; round-off if the discretization conserves linear momentum. Only at a sample and at the end of a
  /// run, where MovingBody::internal is kept; else throws std::logic_error.
  double force_imbalance() const;
  /// The same for the moments of the internal forces about the origin, in large motion in the deformed
  /// position.
  double moment_imbalance() const;
  /// The cost of the run so far.
  Price& price() { return read_clocks(), motion_.price; }
  const Price& price() const { return read_clocks(), motion_.price; }

 private:
  void add_body(std::size_t index, std::unique_ptr<Discretization> discretization);
  void find_critical_step();
  void start_velocities();
  void forces();             ///< all forces at u(n): the internal forces, then those of the effects
  bool may_be_last() const;  ///< whether the present step may be the last one
  void reaction_work();      ///< adds the work of prescribed motion over half a step, at the present forces
  void plan();               ///< when to take samples and snapshots, when to check, and when to end
  /// Adapts the step to the deformation (march_step.cpp).
  void follow_deformation();
  void change_step();     ///< from dt to next_dt, at a whole step with known forces
  void kick_and_drift();  ///< v += dt f/m, u += dt v, with damping and viscosity
  void move_rigid_bodies();
  void work_of_outside();  ///< adds the work of external forces over the step
  /// Every watch_every_ steps: checks the run, the settling and the damping rate (march_watch.cpp).
  void watch(bool last);
  double allowance() const;
  void look_at_energy(const Ledger& l);
  void look_at_units();
  void settle(const Ledger& l);
  void say_what_did_not_settle();
  double frequency_of_motion();
  // Kinetic damping: march_settling.cpp.
  bool past_kinetic_peak() const;
  void go_back_half_a_step();
  void start_again_from_rest();
  double work_of_the_step()
      const;  ///< J: work of all present forces over half a step at the present velocities
  /// The energies that the leap-frog conserves, at a whole step, J: 1/2 v- . M v+ with v- and v+ the
  /// velocities half a step before and after; and what damping and viscosity dissipate in half a step at v-.
  struct Kinetic {
    double energy = 0, damping = 0, viscosity = 0;
  };
  Kinetic kinetic() const;
  /// 1/8 (v+ - v-) . M (v+ - v-), J: the kinetic energy at the whole step, 1/2 v . M v with v = (v- + v+)/2,
  /// minus Kinetic::energy.
  double energy_of_half_a_kick() const;
  template <class Take>
  void internal_forces(const MovingBody& body, Take&& take) const;
  std::string fastest_point() const;
  [[noreturn]] void fail(Stopped::Watch watch, const std::string& place, const std::string& what,
                         const std::string& advice) const;

  Motion motion_;
  EffectList effects_;
  double critical_ = 0, critical_alone_ = 0;  ///< s
  // The step that is adapted to the deformation; see march_step.cpp.
  bool follows_ = false, given_step_ = false;
  double safety_ = 0.9, critical_now_ = 0, smallest_step_ = 0;
  double seen_share_ = 1;  ///< critical step over that of the undeformed bodies, at the last estimate
  long step_changes_ = 0, seen_step_ = 0, next_estimate_ = 0;
  std::size_t touching_ = 0;
  /// Something that is done at regular intervals of time.
  struct Schedule {
    double interval = 0, next = 0;  ///< s
    bool is_due(double time, double dt) const { return !(time < next - 0.5 * dt); }
    bool due(double time, double dt) {
      if (!is_due(time, dt)) return false;
      next += interval;
      return true;
    }
  };
  Schedule samples_, snapshots_;
  long planned_ = 1;
  bool adaptive_damping_ = false, kinetic_damping_ = false, settled_ = false;
  long watch_every_ = 1;
  double external_work_ = 0;
  double external_passed_ = 0;  ///< sum of |external work| of the steps, J
  double created_ = 0;          ///< J, created by laws without return mapping (negative plastic work)
  double damping_loss_ = 0, viscous_loss_ = 0;
  double initial_energy_ = 0;  ///< J, with Kinetic::energy
  double initial_whole_ = 0;   ///< J, with the kinetic energy at the whole step
  /// Losses (J) in the half step before the first step, which do not belong to the run.
  double start_damping_ = 0, start_viscosity_ = 0;
  bool going_back_ = false;  ///< kinetic damping: this step goes back to the last peak of the kinetic energy
  double still_since_ = -1;  ///< s: when the last check found the bodies at rest; negative: it did not
  /// How far the bodies were from rest at the last check: ratios of the unbalanced forces to the loads, of
  /// the displacement that these can still cause to the displacement, and of the amplitude of the motion to
  /// the displacement.
  struct Residuals {
    double force = 1, displacement = 1, motion = 1;
    bool loads_change = false;
  };
  Residuals residuals_;
  double force_scale_ = 0;  ///< N: the largest forces so far, for bodies without a permanent load
  std::vector<std::string> warnings_;
  bool running_ = false;
  bool keep_internal_ = false;  ///< whether MovingBody::internal is kept at this step
  /// s: the clocks at the start of the run, minus the cost before it was resumed.
  double cpu_before_ = 0, wall_before_ = 0;
  void read_clocks() const;
  bool keep_good_ = false;
  MemoryArchive good_;
};

}  // namespace femsph
