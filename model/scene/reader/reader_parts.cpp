// What completes a body: symmetry planes and bars.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/scene/reader/scene_reader.hpp"

namespace femsph::scene_reader {
namespace {

/// A bar runs along one axis: all but one component of its ends agree.
bool along_an_axis(const Bar& bar) {
  double across = 0, along = std::abs(bar.to[bar.axis()] - bar.from[bar.axis()]);
  for (int a = 0; a < 3; ++a)
    if (a != bar.axis()) across = std::max(across, std::abs(bar.to[a] - bar.from[a]));
  return along > 0 && across <= 1e-9 * along;
}

/// The body that a table names, unless it is rigid: `what` it cannot have.
std::optional<std::size_t> read_deformable(Fields& fields, const Reading& reading, const char* what) {
  const auto body = read_body_of(fields, reading);
  if (!body || !reading.scene.bodies[*body].rigid) return body;
  fields.fault("body", fmt::format("body {} is rigid and has no {}; expected a body with a material",
                                   in_quotes(reading.scene.bodies[*body].name), what));
  return {};
}

}  // namespace

void read_symmetries(Fields& root, Reading& reading) {
  const std::vector<std::string> all = {"x-", "x+", "y-", "y+", "z-", "z+"},
                                 known(all.begin(), all.begin() + (reading.dim == 2 ? 4 : 6));
  for (Fields& fields : root.tables("symmetry")) {
    const auto body = read_deformable(fields, reading, "symmetry planes");
    const auto side = fields.text("at", Need::required, one_of(known));
    const Source source = fields.source("at");
    fields.done();
    if (!body || !side) continue;
    if (std::find(known.begin(), known.end(), *side) == known.end()) {
      fields.fault("at", fmt::format("unknown side {}; expected {}{}", in_quotes(*side), one_of(known),
                                     did_you_mean(*side, known)));
      continue;
    }
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
    if (material && !materials.empty() && !reading.scene.materials.count(*material))
      fields.fault("material", fmt::format("unknown material {}; expected {}{}", in_quotes(*material),
                                           one_of(materials), did_you_mean(*material, materials)));
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

}  // namespace femsph::scene_reader
