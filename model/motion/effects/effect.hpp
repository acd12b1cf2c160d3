#pragma once
// The interface between the time loop (march.hpp) and the effects of a scene. The loop holds the effects that
// its scene contains, and in every step calls only those functions ("hooks") that an effect overrides. An
// effect includes this header and not march.hpp; the loop includes this header and no single effect.
//
// The constructor of an effect sets it up: it finds its nodes or particles ("points"), and throws MotionError
// or InputError.

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/motion/bodies/ledger.hpp"
#include "model/motion/bodies/motion.hpp"
#include "model/motion/effects/catalogue.hpp"
#include "model/numerics/archive.hpp"

namespace femsph {

class Effect {
 public:
  virtual ~Effect() = default;

  // Once, at t = 0, when the forces are known. u is u(0); v is v(0), which start() of each effect adds to,
  // from 0.
  /// Adds initial velocities, of deformable and of rigid bodies.
  virtual void start(Motion&) {}
  /// Then: corrects the initial velocities so that a constraint holds.
  virtual void constrain_start(Motion&) {}
  /// Whether it strains the bodies at t = 0. The energy that this stores belongs to the initial energy.
  virtual bool strains_the_start() const { return false; }

  // In every step, in this order. Forces (N) are added to MovingBody::f and by RigidBody::push().
  /// External forces on one body at u(n), v(n-1/2).
  virtual void push_body(const Motion&, MovingBody&) {}
  virtual void push_rigid(const Motion&, RigidBody&) {}
  /// Forces between bodies.
  virtual void push_between(Motion&) {}
  /// Forces that maintain a constraint; all other forces are known.
  virtual void constrain(Motion&) {}
  /// Reactions of components with prescribed motion, when all forces are known.
  virtual void find_reactions(Motion&) {}
  /// When v is v(n+1/2) and u is u(n+1): sets the components with prescribed motion. Adds the energy (J) that
  /// damping and viscosity dissipate there.
  virtual void after_kick(const Motion&, MovingBody&, double& /*damping*/, double& /*viscosity*/) {}
  /// Adds the work (J) of push_body() over the step from n to n+1, whose v(n+1/2) is known.
  virtual void work_on_body(const Motion&, const MovingBody&, double& /*work*/) const {}
  virtual void work_on_rigid(const Motion&, const RigidBody&, double& /*work*/) const {}
  /// Adds the work (J) of the reactions of prescribed components over half a step at the present v.
  virtual void reaction_work(const Motion&, double& /*work*/) const {}

  // Before the first step, for the critical time step.
  /// Adds to `springs` (N/m, one for each entry of a flat vector) springs to ground that bound the stiffness
  /// of the effect on deformable body `index` from above; returns the largest step (s) that the effect allows
  /// by itself. `frequency2` is the square of the largest angular frequency (1/s^2) of the body without the
  /// effect.
  virtual double add_springs(const Motion&, std::size_t /*index*/, double /*frequency2*/,
                             AlignedVector<double>& /*springs*/) const;

  // When a sample is taken, and when the loop checks the run.
  /// Adds the energy (J) that it stores now and that it has dissipated so far.
  virtual void add_energies(Ledger&) const {}
  /// Saves or restores what it carries from step to step besides u and v, so that a run can be resumed.
  virtual void state(Archive&) {}
  /// How many points are in contact. When the first are, the loop checks its time step at once.
  virtual std::size_t touching() const { return 0; }
  /// Whether bodies can meet or separate. Then a displacement may be rigid-body motion.
  virtual bool bodies_may_part() const { return false; }
  /// Whether its external forces still change after the time t (s), independently of the motion.
  virtual bool changes_after(double) const { return false; }

  using TakeForce = std::function<void(std::size_t point, const Point& force)>;
  /// Each force (N) of push_body() on a body, now.
  virtual void each_force(const Motion&, const MovingBody&, const TakeForce&) const {}
  /// N: the sum of these forces minus the total that the scene gives for the body.
  virtual Point excess_force(const Motion&, const MovingBody&) const { return {}; }
  /// Each force (N) that push_rigid() adds at the centre of a rigid body.
  virtual void each_force_on_rigid(const Motion&, const RigidBody&,
                                   const std::function<void(const Point&)>&) const {}
  /// Adds the sum of the magnitudes (N) of these forces, as the scale for forces out of balance.
  virtual void size_on_body(const Motion&, const MovingBody&, double& /*sum*/) const {}
  virtual void size_on_rigid(const Motion&, const RigidBody&, double& /*sum*/) const {}
  /// Each force (N) of a support that is not the reaction of a fixed component.
  virtual void each_reaction(const Motion&, const MovingBody&,
                             const std::function<void(std::size_t slot, double)>&) const {}
  /// Sets the entries of its contacts: the force (N) of the first body on the second, in the order of
  /// Scene::contacts.
  virtual void contact_forces(std::vector<Point>&) const {}
  /// Lines for `femsph check` and the run record: a name and a value each.
  virtual void describe(const Motion&, std::vector<std::pair<std::string, std::string>>&) const {}
  virtual std::size_t bytes() const { return 0; }
};

/// The hooks that are called in every step, and add_springs.
enum class Hook {
  push_body,
  push_rigid,
  push_between,
  constrain,
  find_reactions,
  after_kick,
  work_on_body,
  work_on_rigid,
  reaction_work,
  add_springs
};

/// The effects of a march, in the order of the catalogue.
class EffectList {
 public:
  EffectList() = default;
  explicit EffectList(Motion& motion);  ///< the effects of its scene
  using Some = std::vector<Effect*>;
  const Some& all() const { return all_; }
  /// Those that override the hook.
  const Some& with(Hook hook) const { return with_[std::size_t(hook)]; }
  bool bodies_may_part() const;  ///< because of at least one of them
  /// The effect of this type; null if the scene does not contain it.
  template <class E>
  const E* find() const {
    for (const Effect* effect : all_)
      if (const auto* found = dynamic_cast<const E*>(effect)) return found;
    return nullptr;
  }

 private:
  std::vector<std::unique_ptr<Effect>> own_;
  Some all_;
  std::array<Some, 10> with_;
};

/// A new effect, and a bit for each hook that its class overrides. (A member function of E itself has another
/// type than that of Effect.)
struct MadeEffect {
  std::unique_ptr<Effect> effect{};
  unsigned hooks = 0;
};
template <class E>
MadeEffect made(std::unique_ptr<E> effect) {
  unsigned hooks = 0;
#define FEMSPH_HOOK(name) \
  if (!std::is_same_v<decltype(&E::name), decltype(&Effect::name)>) hooks |= 1u << unsigned(Hook::name);
  FEMSPH_HOOK(push_body)
  FEMSPH_HOOK(push_rigid)
  FEMSPH_HOOK(push_between)
  FEMSPH_HOOK(constrain)
  FEMSPH_HOOK(find_reactions)
  FEMSPH_HOOK(after_kick)
  FEMSPH_HOOK(work_on_body)
  FEMSPH_HOOK(work_on_rigid)
  FEMSPH_HOOK(reaction_work)
  FEMSPH_HOOK(add_springs)
#undef FEMSPH_HOOK
  return {std::move(effect), hooks};
}
template <class E>
MadeEffect make_effect(Motion& motion) {
  return made(std::make_unique<E>(motion));
}

}  // namespace femsph
