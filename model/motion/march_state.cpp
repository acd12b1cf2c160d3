// The state that is carried from one step to the next and that a resumed run cannot compute again.

#include "model/motion/march.hpp"

namespace femsph {

void March::state(Archive& archive) {
  archive("step", motion_.step);
  archive("dt", motion_.dt);
  archive.below("step control", [&] {
    archive("first", motion_.price.dt);
    archive("critical", critical_now_);
    archive("next", motion_.next_dt);
    archive("smallest", smallest_step_);
    archive("since_time", motion_.since_time);
    archive("since_step", motion_.since_step);
    archive("changes", step_changes_);
    archive("seen_share", seen_share_);
    archive("seen_step", seen_step_);
    archive("next_estimate", next_estimate_);
    archive("touching", touching_);
  });
  archive.below("plan", [&] {
    archive("steps", planned_);
    archive("watch_every", watch_every_);
    for (const auto& [name, schedule] :
         {std::pair{"samples", &samples_}, std::pair{"snapshots", &snapshots_}})
      archive.below(name, [&, r = schedule] {
        archive("next", r->next);
        archive("interval", r->interval);
      });
  });
  archive("settled", settled_);
  archive("damping_rate", motion_.damping_rate);
  archive("still_since", still_since_);
  archive("going_back", going_back_);
  archive("force_scale", force_scale_);
  archive.below("energy", [&] {
    archive("external", external_work_);
    archive("passed", external_passed_);
    archive("created", created_);
    archive("damping", damping_loss_);
    archive("viscosity", viscous_loss_);
    archive("initial", initial_energy_);
    archive("initial_whole", initial_whole_);
    archive("start_damping", start_damping_);
    archive("start_viscosity", start_viscosity_);
  });
  for (MovingBody& body : motion_.bodies)
    archive.below("body " + body.name, [&] {
      archive("u", body.u);
      archive("v", body.v);
      body.discretization->state(archive);
    });
  for (RigidBody& body : motion_.rigid) archive.below("body " + body.name, [&] { body.state(archive); });
  for (Effect* effect : effects_.all()) effect->state(archive);
}

}  // namespace femsph
