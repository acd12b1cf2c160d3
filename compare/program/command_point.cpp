#include <fmt/format.h>

#include "compare/program/commands.hpp"
#include "model/input/toml_fields.hpp"
#include "model/material/point.hpp"
#include "model/results/history.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph::compare {

namespace {

template <class T>
T word(const char* option, const std::string& value, const std::vector<std::pair<std::string, T>>& words) {
  std::vector<std::string> names;
  for (const auto& [name, meaning] : words) {
    if (name == value) return meaning;
    names.push_back(name);
  }
  throw BadCommand(fmt::format(
      "{} cannot be {}; expected {}{}", option, in_quotes(value), one_of(names), did_you_mean(value, names)));
}

const Material& material_named(const Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [known, material] : scene.materials) {
    if (known == name) return material;
    names.push_back(known);
  }
  throw BadCommand(fmt::format("--material: no material {} in {}; expected {}{}", in_quotes(name), scene.file,
                               one_of(names), did_you_mean(name, names)));
}

}  // namespace

int point_command(const PointCommand& command) {
  const Scene scene = read_scene(command.scene);
  Material material = material_named(scene, command.material);
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
