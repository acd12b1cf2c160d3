// Materials and bodies of a scene, and how other tables refer to a body.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/scene/reader/scene_reader.hpp"
#include "model/scene/reader/shape_reader.hpp"
#include "model/scene/shapes/mesh_check.hpp"

namespace femsph::scene_reader {
namespace {

/// dY/dp, given as it is or by the tangent modulus Et of the uniaxial curve: 1/Et = 1/E + 1/H.
double read_hardening(Fields& fields, double young) {
  const auto hardening = fields.quantity(
      "hardening", Need::optional, dimension::pressure, Sign::not_negative);
  const std::string range = "a number from 0 to below 1 (the tangent modulus over Young's)";
  const auto ratio = fields.number("tangent_ratio", Need::optional, range);
  if (ratio && !(*ratio >= 0 && *ratio < 1))
    fields.fault("tangent_ratio", fmt::format("\"tangent_ratio\" is {}; expected {}", *ratio, range));
  if (fields.has("hardening") == fields.has("tangent_ratio"))
    fields.fault(fields.has("hardening") ? "hardening" : "law",
                 fmt::format("{} in {}; expected one of them: \"hardening\" is H, Pa per plastic strain, "
                             "\"tangent_ratio\" is r = Et/E, H = E r / (1 - r)",
                             fields.has("hardening") ? "both \"hardening\" and \"tangent_ratio\""
                                                     : "neither \"hardening\" nor \"tangent_ratio\"",
                             fields.name()));
  return hardening.value_or(ratio ? young * *ratio / (1 - *ratio) : 0.0);
}

/// [materials.NAME.johnson_cook]; `density` of the material, kg/m^3.
JohnsonCook read_johnson_cook(Fields& material, double density) {
  JohnsonCook jc;
  auto table = material.table(
      "johnson_cook", Need::required, "a table with B, n and what else the metal has");
  if (!table) return jc;
  const auto number = [&](const char* key, Need need, double otherwise, double least, double most,
                          const std::string& expected) {
    const auto value = table->number(key, need, expected);
    if (value && !(*value >= least && *value <= most))
      table->fault(key, fmt::format("\"{}\" is {}; expected {}", key, *value, expected));
    return value.value_or(otherwise);
  };
  jc.B = table->quantity("B", Need::required, dimension::pressure, Sign::not_negative).value_or(0);
  jc.n = number(
      "n", Need::required, 1, 1e-3, 1, "a number above 0 and at most 1 (the exponent of the plastic strain)");
  jc.C = number("C", Need::optional, 0, 0, 1, "a number from 0 to 1 (what a rate e times as high adds)");
  jc.rate = table
                ->quantity("reference_rate", jc.C > 0 ? Need::required : Need::optional, dimension::rate,
                           Sign::positive)
                .value_or(1);
  const bool hot = table->has("melting");
  const Need with_heat = hot ? Need::required : Need::optional;
  jc.melting = table->quantity("melting", Need::optional, dimension::temperature, Sign::positive).value_or(0);
  jc.m = number("m", with_heat, 1, 1e-3, 10, "a number above 0 (the exponent of the temperature)");
  jc.room = table->quantity("room", with_heat, dimension::temperature, Sign::positive).value_or(0);
  jc.start = table->quantity("temperature", Need::optional, dimension::temperature, Sign::positive)
                 .value_or(jc.room);
  const auto capacity = table->quantity("heat_capacity", with_heat, dimension::heat_capacity, Sign::positive);
  const double share = number("heat_share", Need::optional, 0.9, 0, 1,
                              "a number from 0 to 1 (the share of plastic work that turns to heat)");
  if (hot && jc.melting <= jc.room)
    table->fault(
        "melting",
        fmt::format("\"melting\" is {:g} K, not above \"room\", {:g} K; expected the higher of the two",
                    jc.melting, jc.room));
  if (!hot)
    for (const char* key : {"m", "room", "temperature", "heat_capacity", "heat_share"})
      if (table->has(key))
        table->fault(
            key, fmt::format("\"{}\" without \"melting\"; expected both, or no effect of heat", key));
  jc.heating = capacity ? share / (density * *capacity) : 0.0;
  table->done();
  return jc;
}

/// Johnson-Cook goes with the plain law alone, and needs a component of stress across the plane.
void check_johnson_cook(Fields& fields, const Plasticity& p, const Reading& reading) {
  for (const char* key : {"hardening", "tangent_ratio"})
    if (fields.has(key))
      fields.fault(
          key,
          fmt::format(
              "\"{}\" with \"johnson_cook\", which says how the metal hardens; expected one of them", key));
  if (p.tension != TensionRule::none)
    fields.fault("tension", "a tension rule with \"johnson_cook\"; expected none");
  if (p.integration != Integration::return_mapping)
    fields.fault("integration", "\"integration\" with \"johnson_cook\"; expected \"return\"");
  if (reading.dim == 2 && reading.scene.plane == Plane::stress)
    fields.fault("johnson_cook",
                 "\"johnson_cook\" in plane stress; expected plane = \"strain\" or \"none\" in [model]");
}

Plasticity read_plasticity(Fields& fields, const Material& material, const Reading& reading) {
  Plasticity p;
  p.yield = fields.quantity("yield", Need::required, dimension::pressure, Sign::positive).value_or(1);
  if (fields.has("johnson_cook")) {
    p.johnson_cook = read_johnson_cook(fields, material.density);
    fields.quantity("hardening", Need::optional, dimension::pressure);
    fields.number("tangent_ratio", Need::optional);
  } else {
    p.hardening = read_hardening(fields, material.young);
  }
  p.tension = fields
                  .choice<TensionRule>("tension", Need::optional,
                                       {{"none", TensionRule::none},
                                        {"sign", TensionRule::sign},
                                        {"principal", TensionRule::principal}})
                  .value_or(TensionRule::none);
  const bool limited = p.tension != TensionRule::none;
  p.tensile_strength = fields
                           .quantity("tensile_strength", limited ? Need::required : Need::optional,
                                     dimension::pressure, Sign::positive)
                           .value_or(0);
  if (!limited && fields.has("tensile_strength"))
    fields.fault(
        "tensile_strength",
        "\"tensile_strength\" without a tension rule; expected tension = \"sign\" or \"principal\" with it");
  p.integration = fields.choice<Integration>("integration", Need::optional, integrations())
                      .value_or(Integration::return_mapping);
  if (p.johnson_cook) check_johnson_cook(fields, p, reading);
  return p;
}

enum class LawWord { elastic, neo_hookean, plastic };

Material read_material(const std::string& name, Fields& fields, const Reading& reading) {
  const auto law = fields.choice<LawWord>(
      "law", Need::required,
      {{"elastic", LawWord::elastic}, {"neo-hookean", LawWord::neo_hookean}, {"plastic", LawWord::plastic}});
  const auto young = fields.quantity("young", Need::required, dimension::pressure, Sign::positive);
  const std::string range = "a number above -1 and below 0.5 (a stable, compressible material)";
  const auto poisson = fields.number("poisson", Need::required, range);
  if (poisson && !(*poisson > -1 && *poisson < 0.5))
    fields.fault("poisson", fmt::format("\"poisson\" is {}; expected {}", *poisson, range));
  const auto density = fields.quantity("density", Need::required, dimension::density, Sign::positive);
  Material material{name, young.value_or(1), poisson.value_or(0), density.value_or(1)};
  if (!law) fields.accept_rest();
  if (law == LawWord::plastic) material.plasticity = read_plasticity(fields, material, reading);
  material.neo_hookean = law == LawWord::neo_hookean;
  if (material.neo_hookean && reading.motion_known && !reading.scene.large_motion)
    fields.fault("law",
                 "\"law\" is \"neo-hookean\" with small motion, where it is the elastic law; expected motion "
                 "= \"large\" in [model], or law = \"elastic\"");
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
