// What a march carries from one step to the next: all that a run which is taken up again cannot work out
// anew.

#include "model/motion/march.hpp"

namespace femsph {

void March::state(Archive& archive) {
  archive("step", step_);
  archive("dt", dt_);
  archive.below("step control", [&] {
    archive("first", price_.dt);
    archive("critical", critical_now_);
    archive("next", next_dt_);
    archive("smallest", smallest_step_);
    archive("since_time", since_time_);
    archive("since_step", since_step_);
    archive("changes", step_changes_);
    archive("seen_share", seen_share_);
    archive("seen_step", seen_step_);
    archive("next_estimate", next_estimate_);
    archive("touching", touching_);
  });
  archive.below("plan", [&] {
    archive("steps", planned_);
    archive("watch_every", watch_every_);
    for (const auto& [name, rhythm] : {std::pair{"samples", &samples_}, std::pair{"snapshots", &snapshots_}})
      archive.below(name, [&, r = rhythm] {
        archive("next", r->next);
        archive("interval", r->interval);
      });
  });
  archive("settled", settled_);
  archive("damping_rate", damping_rate_);
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
  for (MovingBody& body : bodies_)
    archive.below("body " + body.name, [&] {
      archive("u", body.u);
      archive("v", body.v);
      body.discretization->state(archive);
    });
  for (RigidBody& body : rigid_) archive.below("body " + body.name, [&] { body.state(archive); });
  for (ContactPair& contact : contacts_)
    archive.below("contact " + contact.contact().name, [&] { contact.state(archive); });
  if (!ties_.empty()) archive.below("ties", [&] { ties_.state(archive); });
}

void RigidBody::state(Archive& archive) {
  archive("moved", moved);
  archive("velocity", velocity);
  archive("spin", spin);
  for (int a = 0; a < 3; ++a) archive("axis_" + std::to_string(a), axes[a]);
  archive("angle", angle);
}

/// Forces and depths of now follow from the points; what points remember and which pieces they look at does
/// not.
void ContactPair::state(Archive& archive) {
  archive("next_search", next_search_);
  archive("friction_loss", loss_);
  archive("deepest", deepest_);
  archive("touching", touching_);  // the next step looks whether anything did
  for (std::size_t s = 0; s < sides_.size(); ++s)
    for (Surface& surface : sides_[s].surface)
      archive.below("side_" + std::to_string(s), [&] {
        archive("now", surface.now);
        archive("area", surface.area);
        archive("active", surface.active);
      });
  for (std::size_t k = 0; k < passes_.size(); ++k)
    archive.below("pass_" + std::to_string(k), [&] {
      Pass& pass = passes_[k];
      archive("points", pass.points);
      archive("begin", pass.begin);
      archive("pieces", pass.pieces);
      archive.each("piece", pass.holds, &Hold::piece);
      archive.each("touches", pass.holds, &Hold::touches);
      archive.each("stretch", pass.holds, &Hold::stretch);
      archive.each("pull", pass.holds, &Hold::pull);
    });
}

}  // namespace femsph
