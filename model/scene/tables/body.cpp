// Which body a table of a scene names, and whether a point lies in it.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "model/scene/place_extent.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph::scene_reader {
namespace {

std::string bounds(const Shape& shape) {
  std::string text;
  for (int i = 0; i < shape.dim(); ++i)
    text += fmt::format(
        "{}{} in [{:g}, {:g}] mm", i ? ", " : "", "xyz"[i], 1e3 * shape.lower()[i], 1e3 * shape.upper()[i]);
  return text;
}

}  // namespace

Key body_key() {
  return {"body", "a text: the name of a body", "The body that the table belongs to.", false,
          "where the scene has several bodies"};
}

std::vector<std::string> body_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Body& body : scene.bodies) names.push_back(body.name);
  return names;
}

bool usable_name(const std::string& name) {
  const auto allowed = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) || c == '_' || c == '-'); };
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), allowed);
}

std::optional<std::size_t> read_body_of(Fields& fields, const Reading& reading) {
  const auto names = body_names(reading.scene);
  const auto name = fields.text("body", names.size() > 1 ? Need::required : Need::optional,
                                names.empty() ? "the name of a body" : one_of(names));
  if (names.empty()) return {};
  if (!name) return names.size() == 1 && !fields.has("body") ? std::optional<std::size_t>(0) : std::nullopt;
  return fields.position_of(*name, names, "body", "body");
}

std::optional<std::size_t> read_deformable(Fields& fields, const Reading& reading, const char* what) {
  const auto body = read_body_of(fields, reading);
  if (!body || !reading.scene.bodies[*body].rigid) return body;
  fields.fault("body", fmt::format("body {} is rigid and has no {}; expected a body with a material",
                                   in_quotes(reading.scene.bodies[*body].name), what));
  return {};
}

void require_inside(const Fields& fields, const char* key, const Point& point, std::size_t body,
                    const Reading& reading) {
  const Body& owner = reading.scene.bodies[body];
  if (!owner.shape || owner.shape->contains(point, point_tolerance(*owner.shape))) return;
  fields.fault(key, fmt::format("\"{}\" lies outside body {}; expected a point of its {}: {}", key,
                                in_quotes(owner.name), owner.shape->describe(), bounds(*owner.shape)));
}

void require_deformable(const Fields& fields, const char* what, std::size_t body, const Reading& reading) {
  const Body& owner = reading.scene.bodies[body];
  if (owner.rigid)
    fields.fault("body", fmt::format("a {0} in body {1}, which is rigid; the histories hold its motion "
                                     "({2}_x, {2}_vx, ..) without one",
                                     what, in_quotes(owner.name), owner.name));
}

}  // namespace femsph::scene_reader
