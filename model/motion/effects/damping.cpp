// Mass-proportional damping. Motion::damping_rate holds its rate; the kick applies it (march_kick.cpp), in
// the same pass over the points as everything else that changes velocities.

#include "model/motion/effects/catalogue.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph {
namespace {

using namespace scene_reader;

KeyTable damping_keys() {
  return {"[damping]",
          "Mass-proportional damping: a force -c m v on every node or particle of mass m and velocity v.",
          {{"rate", key_holds::quantity(dimension::rate),
            "c. The velocity of a free body decays as exp(-c t).", true}}};
}

void read_damping(Fields& root, Reading& reading) {
  auto damping = root.table("damping", Need::optional, "a table with rate = \"100 1/s\" or the like");
  if (!damping) return;
  reading.scene.damping = damping->quantity("rate", Need::required, dimension::rate, Sign::positive);
  damping->done();
}

}  // namespace

EffectEntry damping_effect() {
  EffectEntry e{{"damping", "mass-proportional damping: a force -c m v on every node or particle"}};
  e.asked_by = "[damping]";
  e.on = [](const Scene& s) { return s.damping.has_value(); };
  e.outside = true;
  e.tables = {damping_keys()};
  e.read = read_damping;
  return e;
}

}  // namespace femsph
