#pragma once
// What an effect does for the march: its hooks. A march holds those effects that its scene asks for, and
// calls in every step only the hooks that they override. An effect includes this and not march.hpp; the march
// includes this and no single effect.
//
// The constructor of an effect sets it up: it finds its points, and throws MotionError or InputError.

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

  // Once, at t = 0, when the forces are known: u(0) is set, v holds v(0) (and 0 before the first effect).
  /// Adds to the velocities v(0) of bodies that deform, and to those of rigid ones.
  virtual void start(Motion&) {}
  /// After all these: corrects them so that a constraint holds.
  virtual void constrain_start(Motion&) {}
  /// The bodies are strained at t = 0: what that has stored belongs to the energy at the start.
  virtual bool strains_the_start() const { return false; }

  // In every step, in this order. Forces go to MovingBody::f and RigidBody::push().
  /// What the outside does to one body at u(n), v(n-1/2).
  virtual void push_body(const Motion&, MovingBody&) {}
  virtual void push_rigid(const Motion&, RigidBody&) {}
  /// What bodies do to each other.
  virtual void push_between(Motion&) {}
  /// Forces that answer to all others, so that a constraint holds.
  virtual void constrain(Motion&) {}
  /// Reactions of driven components, when all forces are known.
  virtual void find_reactions(Motion&) {}
  /// When v is v(n+1/2) and u is u(n+1): sets what is driven. Adds what damping and viscosity take (J).
  virtual void after_kick(const Motion&, MovingBody&, double& /*damping*/, double& /*viscosity*/) {}
  /// Adds the work (J) of push_body() over the step from n to n+1, whose v(n+1/2) is known.
  virtual void work_on_body(const Motion&, const MovingBody&, double& /*work*/) const {}
  virtual void work_on_rigid(const Motion&, const RigidBody&, double& /*work*/) const {}
  /// Adds half a step's work (J) of the reactions of driven components, at v of now.
  virtual void reaction_work(const Motion&, double& /*work*/) const {}

  // Before the first step, for the critical one.
  /// Adds springs to ground (flat, N/m) that bound the stiffness of the effect on body `index`; returns the
  /// largest step (s) that it allows by itself. `frequency2` (1/s^2) is the largest of the body alone.
  virtual double add_springs(const Motion&, std::size_t /*index*/, double /*frequency2*/,
                             AlignedVector<double>& /*springs*/) const;

  // At samples and looks.
  /// What it stores and what it has taken, J.
  virtual void add_energies(Ledger&) const {}
  /// What it carries from step to step beyond u and v, for a run that is taken up again.
  virtual void state(Archive&) {}
  /// How many points touch something: when the first do, the march looks at its step at once.
  virtual std::size_t touching() const { return 0; }
  /// Bodies can come apart or meet: a displacement may be a fall, and forces act where bodies are.
  virtual bool bodies_may_part() const { return false; }
  /// What it does from outside changes after the time t (s), whatever the bodies do.
  virtual bool changes_after(double) const { return false; }

  using TakeForce = std::function<void(std::size_t point, const Point& force)>;
  /// Each force (N) of push_body() on a body, now.
  virtual void each_force(const Motion&, const MovingBody&, const TakeForce&) const {}
  /// N: the sum of these less the total that the scene gives for the body.
  virtual Point excess_force(const Motion&, const MovingBody&) const { return {}; }
  /// N: what push_rigid() adds to the centre, each part of it.
  virtual void each_force_on_rigid(const Motion&, const RigidBody&,
                                   const std::function<void(const Point&)>&) const {}
  /// Adds the sum of their magnitudes (N): what a force out of balance is measured by.
  virtual void size_on_body(const Motion&, const MovingBody&, double& /*sum*/) const {}
  virtual void size_on_rigid(const Motion&, const RigidBody&, double& /*sum*/) const {}
  /// Each force of a support that is not the reaction of a held component.
  virtual void each_reaction(const Motion&, const MovingBody&,
                             const std::function<void(std::size_t slot, double)>&) const {}
  /// Puts the forces (N) of contacts, of the first body on the second, where Scene::contacts has them.
  virtual void contact_forces(std::vector<Point>&) const {}
  /// Lines for `check` and the run record: what, and its value.
  virtual void describe(const Motion&, std::vector<std::pair<std::string, std::string>>&) const {}
  virtual std::size_t bytes() const { return 0; }
};

/// Hooks of every step.
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
  explicit EffectList(Motion& motion);  ///< those that its scene asks for
  using Some = std::vector<Effect*>;
  const Some& all() const { return all_; }
  /// Those that override the hook.
  const Some& with(Hook hook) const { return with_[std::size_t(hook)]; }
  bool bodies_may_part() const;  ///< by one of them at least
  /// The effect of this type; null if the scene does not ask for it.
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

/// An effect of type E, and which hooks E overrides (a member of E itself has another type than Effect's).
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
