#pragma once
// The one explicit loop of both solvers.

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/motion/effects/contact.hpp"
#include "model/motion/discretization.hpp"
#include "model/motion/ledger.hpp"
#include "model/motion/price.hpp"
#include "model/motion/effects/ties.hpp"
#include "model/numerics/array.hpp"

namespace femsph {

/// One discretized body and what the march keeps for it.
struct MovingBody {
  std::string name;
  std::size_t index = 0;  ///< into Scene::bodies
  std::unique_ptr<Discretization> discretization;
  AlignedVector<double> u, v, f;  ///< displacement (m), velocity at the last half step (m/s), force (N); flat
  AlignedVector<double>
      inverse_mass;  ///< flat, 1/kg; 0 where a support holds the component, so that it never moves
  AlignedVector<double> viscous;  ///< N; empty unless the discretization has viscosity
  AlignedVector<double> mass;     ///< flat, kg; empty unless settling or damping needs it
  struct NodalLoad {
    std::size_t slot;  ///< of the flat arrays
    double force;      ///< N at factor 1
    std::size_t load;  ///< index into Scene::loads
  };
  std::vector<NodalLoad> loads;
  /// A held component whose points have inertia in the march: one that moves as its support says, or that its
  /// support stops at t = 0 (velocity 0). It is a free component under its reaction, and the reaction is what
  /// makes it follow. Sorted by slot.
  struct Driven {
    std::size_t slot;
    double velocity;               ///< m/s at factor 1
    std::size_t support;           ///< index into Scene::supports; any where the velocity is 0
    double mass;                   ///< kg
    double start;                  ///< m/s: what [[initial]] gives this point at t = 0
    double before = 0, after = 0;  ///< m/s, at the half steps around now
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
  /// A component whose weighted mean over a place is held at zero: sum_i w_i u_i = 0, by the forces R w_i.
  struct MeanHold {
    std::vector<std::size_t> slots;
    std::vector<double> weights;
    double inverse_mass;  ///< sum_i w_i^2 / m_i, 1/kg
    double reaction = 0;  ///< R, N
  };
  std::vector<MeanHold> means;
};

struct MarchOptions {
  double safety = 0.9;         ///< dt = safety x critical step
  std::optional<double> step;  ///< s: march with exactly this step
};

class March;

/// Called with the motion at a whole step: u and f belong to `time`, v to half a step before.
struct MarchEvents {
  std::function<void(const March&)>
      sample;  ///< Scene::samples times over the duration, first and last step included
  std::function<void(const March&)> snapshot;  ///< Scene::snapshots times
  std::function<void(const March&)> progress;  ///< now and then
  std::function<void(March&)>
      between;  ///< after every step, when March::state() is whole; may throw to leave the march
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

class March {
 public:
  /// Takes the discretization of each of the scene's bodies that deform, in order; `scene` must outlive the
  /// march. Throws MotionError when a support or load finds no point, when nothing can move, or when a given
  /// step is over the limit.
  March(const Scene& scene, std::vector<std::unique_ptr<Discretization>> bodies, const MarchOptions& options);

  /// Marches to the scene's duration, or until settled. Throws MotionError.
  void run(const MarchEvents& events);

  const Scene& scene() const { return scene_; }
  const std::vector<MovingBody>& bodies() const { return bodies_; }  ///< those that deform
  const MovingBody& body(std::size_t index) const;  ///< by its index in Scene::bodies; it deforms
  const std::vector<RigidBody>& rigid_bodies() const { return rigid_; }
  const std::vector<ContactPair>& contacts() const { return contacts_; }
  const Ties& ties() const { return ties_; }
  /// N, of each contact's first body on its second, now, in the order of the scene.
  std::vector<Point> contact_forces() const;
  long step() const { return step_; }
  double time() const { return time_of(step_); }
  double dt() const { return dt_; }
  double smallest_step() const { return smallest_step_; }  ///< s, so far
  long step_changes() const { return step_changes_; }
  bool follows_deformation() const { return follows_; }  ///< the step does
  double critical_step() const { return critical_; }     ///< of the undeformed bodies
  double critical_step_without_contact() const { return critical_alone_; }
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
  /// round-off if the discretization keeps linear momentum.
  double force_imbalance() const;
  /// The same for the moments of the internal forces about the origin (in the deformed body).
  double moment_imbalance() const;
  /// What the run has cost so far.
  Price& price() { return read_clocks(), price_; }
  const Price& price() const { return read_clocks(), price_; }

 private:
  void place_supports_and_loads(MovingBody& body, std::size_t index);
  void place_rigid_bodies_and_contacts();
  void find_critical_step();
  void place_pressure(MovingBody& body, std::size_t load);
  void place_mean_support(MovingBody& body, const Support& support, const std::vector<Weight>& points);
  void hold_means(MovingBody& body);  ///< adds the reactions of mean supports to the forces
  void start_velocities();
  void forces();  ///< gradient, law, divergence of every body; then loads and gravity
  /// Throws MotionError if there are none; `what` acts there.
  std::vector<Weight> points_of(const MovingBody& body, const Place& place, const char* what) const;
  void hold_and_drive(
      MovingBody& body,
      std::size_t index);  ///< march_supports.cpp: which components are held, and which of them move
  void find_reactions();  ///< of driven components: what takes them from the last half step's velocity to the
                          ///< next one's
  void drive(MovingBody& body);  ///< moves the driven components, after the kick
  void count_driven_work();      ///< half a step's work of the reactions there, at the forces of now
  /// The leap-frog over a time tau, damped: v+ = keep v- + push f/m.
  struct Leap {
    double keep, push;
  };
  double time_of(long step) const { return since_time_ + double(step - since_step_) * dt_; }
  Leap leap(double tau) const {
    return {(1 - 0.5 * damping_rate_ * tau) / (1 + 0.5 * damping_rate_ * tau),
            tau / (1 + 0.5 * damping_rate_ * tau)};
  }
  void plan();  ///< when to sample, look and end
  void
  follow_deformation();   ///< march_step.cpp: is the step still below the limit? what should the next one be?
  void change_step();     ///< from dt_ to next_dt_, at a whole step whose forces are known
  void kick_and_drift();  ///< v += dt f/m, u += dt v, with whichever damping is on
  void move_rigid_bodies();
  void
  count_work_of_loads();  ///< and of gravity, over the step about the half step whose velocities are known
  void watch(
      bool last);  ///< now and then: is it still sound, has it settled, how strong should the damping be
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

  const Scene& scene_;
  std::vector<MovingBody> bodies_;
  std::vector<RigidBody> rigid_;
  std::vector<ContactPair> contacts_;
  Ties ties_;
  double critical_ = 0, critical_alone_ = 0, dt_ = 0;
  // What the deformation makes of the step; see march_step.cpp.
  bool follows_ = false, given_step_ = false;
  double safety_ = 0.9, critical_now_ = 0, next_dt_ = 0, smallest_step_ = 0;
  double since_time_ = 0, seen_share_ = 1;  ///< time and step of the last change; what the last estimate was
  long since_step_ = 0, step_changes_ = 0, seen_step_ = 0, next_estimate_ = 0;
  std::size_t touching_ = 0;
  /// Something done now and then.
  struct Rhythm {
    double interval = 0, next = 0;  ///< s
    bool due(double time, double dt) {
      if (time < next - 0.5 * dt) return false;
      next += interval;
      return true;
    }
  };
  Rhythm samples_, snapshots_;
  long planned_ = 1;
  double damping_rate_ = 0;  ///< c, 1/s
  bool adaptive_damping_ = false, kinetic_damping_ = false, settled_ = false;
  long step_ = 0, watch_every_ = 1;
  double external_work_ = 0,
         external_passed_ = 0;  ///< the latter adds up the work of every step without its sign
  double created_ = 0;          ///< by laws that create energy, which say so: negative plastic work
  double damping_loss_ = 0, viscous_loss_ = 0;
  double initial_energy_ = 0;  ///< by the measure of kinetic()
  double initial_whole_ = 0;   ///< with the kinetic energy at the whole step
  double start_damping_ = 0,
         start_viscosity_ = 0;  ///< the half-step losses at the first step, which belong before it
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
  mutable Price price_;
  bool running_ = false;
  double cpu_before_ = 0, wall_before_ = 0;  ///< s: the clocks at the start of the run, less what it had cost
                                             ///< before it was taken up again
  void read_clocks() const;
  bool keep_good_ = false;
  MemoryArchive good_;
};

}  // namespace femsph
