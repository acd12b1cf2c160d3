// Materials and bodies of a scene, and how other tables refer to a body.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/scene/reader/scene_reader.hpp"
#include "model/scene/reader/shape_reader.hpp"
#include "model/scene/shapes/mesh_check.hpp"

namespace femsph::scene_reader {
namespace {

Material read_material(const std::string& name, Fields& fields, const Reading& reading) {
  std::vector<std::pair<std::string, const LawEntry*>> words;
  for (const LawEntry& law : laws()) words.emplace_back(law.entry.word, &law);
  const auto law = fields.choice<const LawEntry*>("law", Need::required, words);
  const auto young = fields.quantity("young", Need::required, dimension::pressure, Sign::positive);
  const std::string range = "a number above -1 and below 0.5 (a stable, compressible material)";
  const auto poisson = fields.number("poisson", Need::required, range);
  if (poisson && !(*poisson > -1 && *poisson < 0.5))
    fields.fault("poisson", fmt::format("\"poisson\" is {}; expected {}", *poisson, range));
  const auto density = fields.quantity("density", Need::required, dimension::density, Sign::positive);
  Material material{name, young.value_or(1), poisson.value_or(0), density.value_or(1)};
  LawInput in{{material.young, material.poisson, material.density}, {}};
  if (reading.dim) in.plane = reading.scene.plane;
  if (!law) fields.accept_rest();
  if (law) material.parameters = (*law)->read(fields, in);
  if (law && (*law)->large_motion_only && reading.motion_known && !reading.scene.large_motion)
    fields.fault("law", fmt::format("\"law\" is {} with small motion, where it is the elastic law; expected "
                                    "motion = \"large\" in [model], or law = \"elastic\"",
                                    in_quotes((*law)->entry.word)));
  fields.done();
  return material;
}

std::vector<std::string> material_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& [name, material] : scene.materials) names.push_back(name);
  return names;
}

// Such a cell is sound where elements take its gradients, but near that corner what they say is poor.
void warn_of_bad_corners(const Fields& fields, const Shape* shape, const Reading& reading) {
  if (!shape || !shape->cells()) return;
  const std::vector<int> cells = cells_with_bad_corners(*shape->cells());
  if (cells.empty()) return;
  constexpr std::size_t most = 5;
  std::string list;
  for (std::size_t i = 0; i < std::min(most, cells.size()); ++i)
    list += fmt::format("{}{}", i ? ", " : "", cell_number(*shape->cells(), cells[i]));
  const Source at = fields.source("file");
  reading.scene.warnings.push_back(fmt::format(
      "{}:{}:{}: {} not convex (cell{} {}{}): sound at {} Gauss points, folded or flat at a corner, where "
      "results are poor",
      reading.scene.file, at.line, at.column,
      cells.size() == 1 ? "one cell of the mesh is" : fmt::format("{} cells of the mesh are", cells.size()),
      cells.size() == 1 ? "" : "s", list, cells.size() > most ? ", .." : "",
      cells.size() == 1 ? "its" : "their"));
}

Body read_body(const std::string& name, Fields& fields, const Reading& reading) {
  Body body{name, read_shape(fields, reading.dim, reading.folder), 1.0, ""};
  warn_of_bad_corners(fields, body.shape.get(), reading);
  const auto rigid = fields.flag("rigid", Need::optional);
  if (!rigid && fields.has("rigid"))
    return fields.accept_rest(), body;  // which keys belong here is not known
  body.rigid = rigid.value_or(false);
  if (body.rigid) return read_rigid_body(fields, body, reading), body;
  const Need need = reading.dim == 2 ? Need::required : Need::optional;
  body.thickness = fields.quantity("thickness", need, dimension::length, Sign::positive).value_or(1.0);
  if (reading.dim == 3 && fields.has("thickness"))
    fields.fault(
        "thickness",
        "\"thickness\" in a three-dimensional scene; expected it only with plane = \"stress\" or \"strain\"");

  const auto materials = material_names(reading.scene);
  body.material = fields.text("material", Need::required, "the name of a material").value_or("");
  if (!body.material.empty() && !materials.empty() && !reading.scene.materials.count(body.material))
    fields.fault("material", fmt::format("unknown material {}; expected {}{}", in_quotes(body.material),
                                         one_of(materials), did_you_mean(body.material, materials)));
  fields.done();
  return body;
}

std::string bounds(const Shape& shape) {
  std::string text;
  for (int i = 0; i < shape.dim(); ++i)
    text += fmt::format(
        "{}{} in [{:g}, {:g}] mm", i ? ", " : "", "xyz"[i], 1e3 * shape.lower()[i], 1e3 * shape.upper()[i]);
  return text;
}

}  // namespace

std::vector<std::string> body_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Body& body : scene.bodies) names.push_back(body.name);
  return names;
}

void read_materials(Fields& root, Reading& reading) {
  for (auto& [name, fields] :
       root.named_tables("materials", Need::required, "at least one table such as [materials.steel]"))
    reading.scene.materials[name] = read_material(name, fields, reading);
}

void read_bodies(Fields& root, Reading& reading) {
  for (auto& [name, fields] :
       root.named_tables("bodies", Need::required, "at least one table such as [bodies.beam]"))
    reading.scene.bodies.push_back(read_body(name, fields, reading));
  const auto& all = reading.scene.bodies;
  if (!all.empty() && std::all_of(all.begin(), all.end(), [](const Body& body) { return body.rigid; }))
    root.fault("bodies", "every body is rigid; expected one at least that deforms");
}

std::optional<std::size_t> read_body_of(Fields& fields, const Reading& reading) {
  const auto names = body_names(reading.scene);
  const auto name = fields.text("body", names.size() > 1 ? Need::required : Need::optional,
                                names.empty() ? "the name of a body" : one_of(names));
  if (names.empty()) return {};
  if (!name) return names.size() == 1 && !fields.has("body") ? std::optional<std::size_t>(0) : std::nullopt;
  const auto found = std::find(names.begin(), names.end(), *name);
  if (found != names.end()) return found - names.begin();
  fields.fault("body", fmt::format("unknown body {}; expected {}{}", in_quotes(*name), one_of(names),
                                   did_you_mean(*name, names)));
  return {};
}

double point_tolerance(const Shape& shape) {
  const Point a = shape.lower(), b = shape.upper();
  return 1e-6 * std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

void require_inside(const Fields& fields, const char* key, const Point& point, std::size_t body,
                    const Reading& reading) {
  const Body& owner = reading.scene.bodies[body];
  if (!owner.shape || owner.shape->contains(point, point_tolerance(*owner.shape))) return;
  fields.fault(key, fmt::format("\"{}\" lies outside body {}; expected a point of its {}: {}", key,
                                in_quotes(owner.name), owner.shape->describe(), bounds(*owner.shape)));
}

}  // namespace femsph::scene_reader
