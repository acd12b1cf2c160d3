// What rigid bodies and contacts add to the march.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/motion/critical_step.hpp"
#include "model/motion/march.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

const MovingBody& March::body(std::size_t index) const {
  return *std::find_if(
      bodies_.begin(), bodies_.end(), [&](const MovingBody& body) { return body.index == index; });
}

void March::place_rigid_bodies_and_contacts() {
  std::vector<ContactPair::Party> party;
  std::size_t deformable = 0;
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
    const bool rigid = scene_.bodies[b].rigid;
    party.push_back({rigid, rigid ? rigid_.size() : deformable++});
    if (rigid) rigid_.emplace_back(scene_, b);
  }
  for (const Contact& contact : scene_.contacts)
    if (!contact.tied)
      contacts_.emplace_back(
          scene_, contact, std::array{party[contact.between[0]], party[contact.between[1]]}, bodies_);
  ties_ = Ties(scene_, bodies_);
}

std::vector<Point> March::contact_forces() const {
  std::vector<Point> forces;
  auto pair = contacts_.begin();
  auto bond = ties_.bonds().begin();
  for (const Contact& contact : scene_.contacts)
    forces.push_back(contact.tied ? (bond++)->force : (pair++)->force());
  return forces;
}

/// The least over the bodies, with the springs that bound the penalty of their contacts. A spring that lets
/// go in mid-step gives back up to (omega dt)^2 of a point's energy too much, omega^2 = k / m its own
/// frequency; omega dt <= 1.1 keeps that small (found by trial: at 1.4 a chattering contact doubled its
/// energy).
void March::find_critical_step() {
  critical_ = critical_alone_ = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const MovingBody& body = bodies_[b];
    const double alone = femsph::critical_step(*body.discretization, body.inverse_mass);
    critical_alone_ = std::min(critical_alone_, alone);
    double with = alone;
    AlignedVector<double> springs(contacts_.empty() ? 0 : body.u.size(), 0.0);
    for (const ContactPair& contact : contacts_)
      with = std::min(with, contact.add_springs(b, body, rigid_, 4 / (alone * alone), springs));
    double own = 0;
    for (std::size_t i = 0; i < springs.size(); ++i) own = std::max(own, springs[i] * body.inverse_mass[i]);
    if (own > 0)
      with = std::min({with, 1.1 / std::sqrt(own),
                       femsph::critical_step(*body.discretization, body.inverse_mass, springs)});
    critical_ = std::min(critical_, with);
  }
}

void March::move_rigid_bodies() {
  const auto [keep, push] = leap(dt_);
  for (RigidBody& body : rigid_) {
    const double before = body.product(keep, push, 1, 2);  // v-.v- + 2 v-.v+
    body.kick(keep, push);
    damping_loss_ += 0.25 * damping_rate_ * dt_ * (before + body.product(0, 0, 1, 0));
    body.drift(dt_);
  }
}

}  // namespace femsph
