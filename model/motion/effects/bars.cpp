// Reinforcing bars. Which points carry a bar: bodies/bars.hpp; their law: material/bar_law.hpp. The forces
// are added by the discretizations.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/motion/effects/catalogue.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph {
namespace {

using namespace scene_reader;

KeyTable bar_keys() {
  return {"[bars.NAME]",
          "A reinforcing bar parallel to a coordinate axis, perfectly bonded to its body. It adds its "
          "stiffness and mass to those of the body.",
          {body_key(),
           {"from", key_holds::vector(dimension::length), "One end, in the undeformed body.", true},
           {"to", key_holds::vector(dimension::length),
            "The other end. It differs from the first in one component.", true},
           {"area", key_holds::quantity(dimension::area),
            "Cross-sectional area; in a plane scene that of all bars over the thickness of the body.", true},
           {"material", "a text: the name of a material",
            "The material of the bar. Its law must be one that bars can have.", true}}};
}

/// A bar runs along one axis: all but one component of its ends agree.
bool along_an_axis(const Bar& bar) {
  double across = 0, along = std::abs(bar.to[bar.axis()] - bar.from[bar.axis()]);
  for (int a = 0; a < 3; ++a)
    if (a != bar.axis()) across = std::max(across, std::abs(bar.to[a] - bar.from[a]));
  return along > 0 && across <= 1e-9 * along;
}

void read_bars(Fields& root, Reading& reading) {
  std::vector<std::string> materials;
  for (const auto& [name, material] : reading.scene.materials) materials.push_back(name);
  for (auto& [name, fields] : root.named_tables("bars", Need::optional, "tables such as [bars.bottom]")) {
    const auto body = read_deformable(fields, reading, "bars");
    const auto from = fields.vector("from", Need::required, dimension::length, reading.dim);
    const auto to = fields.vector("to", Need::required, dimension::length, reading.dim);
    const auto area = fields.quantity("area", Need::required, dimension::area, Sign::positive);
    const auto material = fields.text("material", Need::required, "the name of a material");
    fields.done();
    if (material && !materials.empty()) fields.position_of(*material, materials, "material", "material");
    if (!body || !from || !to || !area || !material) continue;
    const auto known = reading.scene.materials.find(*material);
    if (known != reading.scene.materials.end())
      if (const std::string why = known->second.bar().refusal; !why.empty())
        fields.fault("material", fmt::format("material {} {}", in_quotes(*material), why));
    const Bar bar{name, *body, *from, *to, *area, *material, fields.source()};
    require_inside(fields, "from", *from, *body, reading);
    require_inside(fields, "to", *to, *body, reading);
    if (!along_an_axis(bar))
      fields.fault(
          "to", "the bar runs along no axis; expected \"from\" and \"to\" to differ in one component");
    else
      reading.scene.bars.push_back(bar);
  }
}

}  // namespace

EffectEntry bars_effect() {
  EffectEntry e{{"bars", "reinforcing bars, perfectly bonded to their body"}};
  e.asked_by = "[bars.NAME]";
  e.on = [](const Scene& s) { return !s.bars.empty(); };
  e.tables = {bar_keys()};
  e.read = read_bars;
  return e;
}

}  // namespace femsph
