#pragma once
// The one explicit loop of both solvers.

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
  std::optional<double> step;  ///< s: march with exactly this step
};

class March;

/// Called with the motion at a whole step: u and f belong to `time`, v to half a step before.
struct MarchEvents {
  /// Scene::samples times over the duration, first and last step included.
  std::function<void(const March&)> sample;
  std::function<void(const March&)> snapshot;  ///< Scene::snapshots times
  std::function<void(const March&)> progress;  ///< now and then
  /// After every step, when March::state() is whole; may throw to leave the march.
  std::function<void(March&)> between;
};

class March {
 public:
  /// Takes the discretization of each of the scene's bodies that deform, in order; `scene` must outlive the
  /// march. Throws MotionError when a support or load finds no point, when nothing can move, or when a given
  /// step is over the limit.
  March(const Scene& scene, std::vector<std::unique_ptr<Discretization>> bodies, const MarchOptions& options);
  March(const March&) = delete;

  /// Marches to the scene's duration, or until settled. Throws MotionError.
  void run(const MarchEvents& events);

  const Scene& scene() const { return motion_.scene; }
  const Motion& motion() const { return motion_; }
  const std::vector<MovingBody>& bodies() const { return motion_.bodies; }  ///< those that deform
  const MovingBody& body(std::size_t index) const;  ///< by its index in Scene::bodies; it deforms
  const std::vector<RigidBody>& rigid_bodies() const { return motion_.rigid; }
  const EffectList& effects() const { return effects_; }
  /// N, of each contact's first body on its second, now, in the order of the scene.
  std::vector<Point> contact_forces() const;
  long step() const { return motion_.step; }
  double time() const { return motion_.time(); }
  double dt() const { return motion_.dt; }
  double smallest_step() const { return smallest_step_; }  ///< s, so far
  long step_changes() const { return step_changes_; }
  bool follows_deformation() const { return follows_; }  ///< the step does
  double critical_step() const { return critical_; }     ///< of the undeformed bodies
  double critical_step_without_contact() const { return critical_alone_; }
  bool bounded_by_effects() const { return !effects_.with(Hook::add_springs).empty(); }  ///< the step is
  long planned_steps() const;
  bool settled() const { return settled_; }
  /// N: what all its supports together exert on a held component, now.
  double reaction(const MovingBody& body, std::size_t slot) const;
  /// m/s, at the whole step of now: the mean of the half steps around it.
  double velocity(const MovingBody& body, std::size_t slot) const;
  Point velocity(const RigidBody& body) const;  ///< of its centre
  Point spin(const RigidBody& body) const;      ///< its angular momentum about the centre, kg m^2/s
  /// What the user should know, a sentence each: of the scene, of its discretizations, and of the march so
  /// far. Those known before the first step come first and stay.
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// All that a run which is taken up again needs; to be saved between two steps (MarchEvents::between).
  void state(Archive& archive);
  /// Before run(): keep, in memory, the state of the last look that found everything sound. Large motion,
  /// plasticity and contact only: what a small elastic motion does at a step within the limit stays bounded.
  void keep_good_states();
  /// Back to that state, for its fields; false if there is none. The march cannot go on from there.
  bool return_to_good_state();
  /// Energies at the current whole step, J. Costs a pass over the model: for samples, not for every step.
  Ledger ledger() const;
  /// |sum of internal forces| / sum of |internal forces| at the current whole step, the larger of all bodies:
  /// round-off if the discretization keeps linear momentum. At a sample and at the end of a run: only there
  /// the internal forces are kept by themselves.
  double force_imbalance() const;
  /// The same for the moments of the internal forces about the origin (in the deformed body).
  double moment_imbalance() const;
  /// What the run has cost so far.
  Price& price() { return read_clocks(), motion_.price; }
  const Price& price() const { return read_clocks(), motion_.price; }

 private:
  void add_body(std::size_t index, std::unique_ptr<Discretization> discretization);
  void find_critical_step();
  void start_velocities();
  void forces();             ///< gradient, law, divergence of every body; then what effects add
  bool may_be_last() const;  ///< this step
  void reaction_work();  ///< half a step's work of the reactions of driven components, at the forces of now
  void plan();           ///< when to sample, look and end
  /// march_step.cpp: is the step still below the limit, and what should the next one be?
  void follow_deformation();
  void change_step();     ///< from dt to next_dt, at a whole step whose forces are known
  void kick_and_drift();  ///< v += dt f/m, u += dt v, with whichever damping is on
  void move_rigid_bodies();
  void work_of_outside();  ///< over the step about the half step whose velocities are known
  /// Now and then: is it still sound, has it settled, how strong should the damping be?
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
  double work_of_the_step() const;  ///< half a step's work of all forces of now at the velocities of now, J
  /// What the march's energies are made of at a whole step: 1/2 v- . M v+, and half a step's loss to damping
  /// and viscosity at v-.
  struct Kinetic {
    double energy = 0, damping = 0, viscosity = 0;
  };
  Kinetic kinetic() const;
  /// 1/8 (v+ - v-) . M (v+ - v-): what the kinetic energy at the whole step, 1/2 v . M v with v = (v- +
  /// v+)/2, has beyond Kinetic::energy.
  double energy_of_half_a_kick() const;
  /// Axes normal to the body's symmetry planes: along these its other half pushes back.
  std::array<bool, 3> mirrored_axes(const MovingBody& body) const;
  template <class Take>
  void internal_forces(const MovingBody& body, Take&& take) const;
  std::string fastest_point() const;
  [[noreturn]] void fail(Stopped::Watch watch, const std::string& place, const std::string& what,
                         const std::string& advice) const;

  Motion motion_;
  EffectList effects_;
  double critical_ = 0, critical_alone_ = 0;  ///< s
  // What the deformation makes of the step; see march_step.cpp.
  bool follows_ = false, given_step_ = false;
  double safety_ = 0.9, critical_now_ = 0, smallest_step_ = 0;
  double seen_share_ = 1;  ///< what the last estimate was
  long step_changes_ = 0, seen_step_ = 0, next_estimate_ = 0;
  std::size_t touching_ = 0;
  /// Something done now and then.
  struct Rhythm {
    double interval = 0, next = 0;  ///< s
    bool is_due(double time, double dt) const { return !(time < next - 0.5 * dt); }
    bool due(double time, double dt) {
      if (!is_due(time, dt)) return false;
      next += interval;
      return true;
    }
  };
  Rhythm samples_, snapshots_;
  long planned_ = 1;
  bool adaptive_damping_ = false, kinetic_damping_ = false, settled_ = false;
  long watch_every_ = 1;
  double external_work_ = 0;
  double external_passed_ = 0;  ///< the work of every step without its sign
  double created_ = 0;          ///< by laws that create energy, which say so: negative plastic work
  double damping_loss_ = 0, viscous_loss_ = 0;
  double initial_energy_ = 0;  ///< by the measure of kinetic()
  double initial_whole_ = 0;   ///< with the kinetic energy at the whole step
  /// The half-step losses at the first step, which belong before it.
  double start_damping_ = 0, start_viscosity_ = 0;
  bool going_back_ = false;  ///< kinetic damping: this step leads back to the last peak of the kinetic energy
  double still_since_ = -1;  ///< s: at rest when last looked at; below 0: still moving
  /// How far from rest at the last look, each as a share: unbalanced forces of the loads; the displacement
  /// that they can still make, and the amplitude of what moves, of the displacement. All below the tolerance:
  /// settled.
  struct Unrest {
    double force = 1, displacement = 1, motion = 1;
    bool loads_change = false;
  };
  Unrest unrest_;
  double force_scale_ = 0;  ///< N: the largest forces so far, where nothing loads the bodies for good
  std::vector<std::string> warnings_;
  bool running_ = false;
  bool keep_internal_ = false;  ///< the internal forces of this step, by themselves
  /// s: the clocks at the start of the run, less what it had cost before it was taken up again.
  double cpu_before_ = 0, wall_before_ = 0;
  void read_clocks() const;
  bool keep_good_ = false;
  MemoryArchive good_;
};

}  // namespace femsph
