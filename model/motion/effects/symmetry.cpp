// Symmetry planes. The displacement along their normal is held as by a support (Scene::holds, supports.cpp);
// SPH mirrors its particles at them (sph/particles).

#include <fmt/format.h>

#include <algorithm>

#include "model/motion/effects/catalogue.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph {
namespace {

using namespace scene_reader;

KeyTable symmetry_keys() {
  return {"[[symmetry]]",
          "A plane side of a body that is a symmetry plane: the scene describes one half of the problem.",
          {body_key(),
           {"at", "a text: a side of the bounding box, such as \"x-\"",
            "The side. The displacement along its normal is zero.", true}}};
}

void read_symmetries(Fields& root, Reading& reading) {
  const std::vector<std::string> all = {"x-", "x+", "y-", "y+", "z-", "z+"},
                                 known(all.begin(), all.begin() + (reading.dim == 2 ? 4 : 6));
  for (Fields& fields : root.tables("symmetry")) {
    const auto body = read_deformable(fields, reading, "symmetry planes");
    const auto side = fields.text("at", Need::required, one_of(known));
    const Source source = fields.source("at");
    fields.done();
    if (!body || !side) continue;
    if (!fields.position_of(*side, known, "at", "side")) continue;
    auto& planes = reading.scene.symmetries;
    const bool again = std::any_of(planes.begin(), planes.end(), [&](const Symmetry& s) {
      return s.place.body == *body && s.place.sides[0] == *side;
    });
    if (again)
      fields.fault("at", fmt::format("side {} is a symmetry plane already; expected each plane once",
                                     in_quotes(*side)));
    else
      planes.push_back({Place{*body, {*side}, {}, source, {}}});
  }
}

}  // namespace

EffectEntry symmetry_effect() {
  EffectEntry e{{"symmetry", "a plane side of a body that is a symmetry plane of the problem"}};
  e.asked_by = "[[symmetry]]";
  e.on = [](const Scene& s) { return !s.symmetries.empty(); };
  e.outside = true;
  e.tables = {symmetry_keys()};
  e.read = read_symmetries;
  return e;
}

}  // namespace femsph
