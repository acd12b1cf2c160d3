// Reads the materials and bodies of a scene.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/scene/reader/scene_parts.hpp"
#include "model/scene/shapes/mesh_check.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph::scene_reader {
namespace {

Material read_material(const std::string& name, Fields& fields, const Reading& reading) {
  std::vector<std::pair<std::string, const LawEntry*>> words;
  for (const LawEntry& law : laws()) words.emplace_back(law.entry.word, &law);
  const auto law = fields.choice<const LawEntry*>("law", Need::required, words);
  const bool fluid = law && (*law)->fluid;
  const Need need = fluid ? Need::optional : Need::required;
  const auto young = fields.quantity("young", need, dimension::pressure, Sign::positive);
  const std::string range = "a number above -1 and below 0.5 (a stable, compressible material)";
  const auto poisson = fields.number("poisson", need, range);
  if (poisson && !(*poisson > -1 && *poisson < 0.5))
    fields.fault("poisson", fmt::format("\"poisson\" is {}; expected {}", *poisson, range));
  const auto density = fields.quantity("density", Need::required, dimension::density, Sign::positive);
  if (fluid)
    for (const char* key : {"young", "poisson"})
      if (fields.has(key))
        fields.fault(
            key, fmt::format("\"{}\" with law = {}, which has no shear stiffness; expected the table "
                             "\"eos\" alone",
                             key, in_quotes((*law)->entry.word)));
  Material material{name, young.value_or(1), poisson.value_or(0), density.value_or(1)};
  if (fluid) material.young = 0, material.poisson = 0.5;
  LawInput in{{material.young, material.poisson, material.density}, {}};
  if (reading.dim) in.plane = reading.scene.plane;
  if (!law) fields.accept_rest();
  if (law) material.parameters = (*law)->read(fields, in);
  if (law && reading.motion_known && !reading.scene.large_motion) {
    const std::string expected = "expected motion = \"large\" in [model]";
    if (fluid)
      fields.fault(
          "law", fmt::format("\"law\" is {} with small motion; {}", in_quotes((*law)->entry.word), expected));
    else if ((*law)->large_motion_only)
      fields.fault(
          "law", fmt::format("\"law\" is {} with small motion, where it is the elastic law; {}, or law = "
                             "\"elastic\"",
                             in_quotes((*law)->entry.word), expected));
    if (material.plasticity() && material.plasticity()->eos)
      fields.fault("eos", "\"eos\" with small motion; " + expected);
  }
  fields.done();
  return material;
}

std::vector<std::string> material_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& [name, material] : scene.materials) names.push_back(name);
  return names;
}

// Elements can use such a cell, since they compute gradients at Gauss points, but results near that corner
// are poor.
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

/// The keys of a rigid body besides its shape: its mass.
void read_rigid_body(Fields& fields, Body& body, const Reading& reading) {
  const bool by_density = fields.has("density") && !fields.has("mass");
  const bool needs_mass = !by_density && !fields.misspelt({"density"});
  const auto mass = fields.quantity(
      "mass", needs_mass ? Need::required : Need::optional, dimension::mass, Sign::positive);
  const auto density = fields.quantity("density", Need::optional, dimension::density, Sign::positive);
  if (fields.has("mass") && fields.has("density"))
    fields.fault("density", "both \"mass\" and \"density\" are given; expected one of them");
  const bool plane = reading.dim == 2;
  body.thickness = fields
                       .quantity("thickness", plane && by_density ? Need::required : Need::optional,
                                 dimension::length, Sign::positive)
                       .value_or(1.0);
  if (reading.dim == 3 && fields.has("thickness"))
    fields.fault(
        "thickness",
        "\"thickness\" in a three-dimensional scene; expected it only with plane = \"stress\" or \"strain\"");
  if (body.shape && body.shape->cells())
    fields.fault("shape", "a rigid body made of cells; expected \"box\", \"disc\" or \"sphere\"");
  else if (body.shape && !body.shape->rigid())
    fields.fault(
        "shape", fmt::format("a rigid {}; expected \"box\", \"disc\" or \"sphere\"", body.shape->describe()));
  if (!usable_name(body.name))
    fields.fault(
        "shape",
        fmt::format("the name {} cannot be used; expected letters, digits, _ and - (it names columns)",
                    in_quotes(body.name)));
  fields.done();
  body.mass = mass.value_or(body.shape && density ? *density * body.shape->measure() * body.thickness : 1.0);
}

Body read_body(const std::string& name, Fields& fields, const Reading& reading) {
  Body body{name, read_shape(fields, reading.dim, reading.folder), 1.0, ""};
  warn_of_bad_corners(fields, body.shape.get(), reading);
  const auto rigid = fields.flag("rigid", Need::optional);
  if (!rigid && (fields.has("rigid") || fields.misspelt({"rigid"})))
    return fields.accept_rest(), fields.done(), body;  // it is not known which keys the body should have
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
  if (!body.material.empty() && !materials.empty())
    fields.position_of(body.material, materials, "material", "material");
  fields.done();
  return body;
}

}  // namespace

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

}  // namespace femsph::scene_reader
