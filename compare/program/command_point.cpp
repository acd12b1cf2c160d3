// `femsph point`: the stress of one material point along a path of strains, without a discretization.

#include <fmt/format.h>

#include "compare/program/commands.hpp"
#include "model/input/lookup.hpp"
#include "model/input/toml_fields.hpp"
#include "model/material/point.hpp"
#include "model/results/history.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph::compare {

namespace {

template <class T>
T word(const char* option, const std::string& value, const std::vector<std::pair<std::string, T>>& words) {
  return value_named<BadCommand>(words, value, fmt::format("{} cannot be {}", option, in_quotes(value)));
}

}  // namespace

int point_command(const PointCommand& command) {
  const Scene scene = read_scene(command.scene);
  Material material = value_named<BadCommand>(
      scene.materials, command.material,
      fmt::format("--material: no material {} in {}", in_quotes(command.material), scene.file));
  const Plane plane =
      command.plane.empty()
          ? scene.plane
          : word<Plane>("--plane", command.plane,
                        {{"stress", Plane::stress}, {"strain", Plane::strain}, {"none", Plane::none}});
  if (!command.integration.empty()) {
    const Integration integration = word("--integration", command.integration, integrations());
    auto* plasticity = std::get_if<Plasticity>(&material.parameters);
    if (!plasticity)
      throw BadCommand(fmt::format("--integration: the material {} is elastic", in_quotes(material.name)));
    plasticity->integration = integration;
  }
  const auto path = read_path(
      read_text_file(command.path, "a path of strains", Length::any), command.path, plane);
  const std::string answer = point_csv(material.law(plane), plane, path);
  if (command.out.empty())
    fmt::print("{}", answer);
  else
    write_text(answer, command.out);
  return 0;
}

}  // namespace femsph::compare
