// The keys of materials, bodies, symmetry planes and bars.

#include "model/scene/reader/scene_page.hpp"
#include "model/scene/scene.hpp"

namespace femsph::scene_reader {
namespace {

const std::string axes = key_holds::words(std::vector<std::string>{"x", "y", "z"});
const std::string parts = key_holds::words(std::vector<std::string>{"whole", "half", "quarter"});

std::vector<Entry> law_entries() {
  const std::string pressure = key_holds::quantity(dimension::pressure);
  return {
      {"elastic", "isotropic and linear"},
      {"neo-hookean", "elastic at large strain; with motion = \"large\""},
      {"plastic",
       "von Mises plasticity with linear hardening or Johnson and Cook's",
       {{"yield", pressure, "The yield stress; A of Johnson and Cook.", true},
        {"hardening", pressure,
         "H, the slope of the yield stress over the plastic strain. Either this or \"tangent_ratio\"."},
        {"tangent_ratio", key_holds::number,
         "r = Et/E of the uniaxial curve, 0 to below 1: H = E r / (1 - r). Either this or \"hardening\"."},
        {"tension", key_holds::words(std::vector<std::string>{"none", "sign", "principal"}),
         "A limit on tension: \"sign\" takes \"tensile_strength\" as the yield stress where the mean stress "
         "is tension, \"principal\" cuts principal stresses at it. \"none\" unless given."},
        {"tensile_strength", pressure, "The limit of the tension rule.", false,
         "with \"sign\" or \"principal\""},
        {"integration", key_holds::words(integrations()),
         "How the stress is brought to the yield surface: \"return\" (unless given) maps it back, the others "
         "let it pass, for comparison."}}}};
}

/// Of discs, cylinders, rings and tubes.
std::vector<Key> round_keys(bool hollow, bool space, bool cells) {
  const std::string length = key_holds::quantity(dimension::length);
  std::vector<Key> keys = {{"centre", key_holds::vector(dimension::length),
                            space ? "The centre of the end where the axis begins." : "The centre.", true}};
  if (hollow) keys.push_back({"inner", length, "The inner radius.", true});
  keys.push_back({hollow ? "outer" : "radius", length, hollow ? "The outer radius." : "The radius.", true});
  if (space) keys.push_back({"axis", axes, "The direction of the axis.", true});
  if (space) keys.push_back({"length", length, "Along the axis.", true});
  if (cells)
    keys.push_back({"part", parts,
                    "\"half\": second axis of the section above the centre; \"quarter\": both axes. "
                    "\"whole\" unless given."});
  return keys;
}

std::vector<Entry> shape_entries() {
  const std::string vector = key_holds::vector(dimension::length);
  std::vector<Entry> all = {
      {"box",
       "sides along the axes",
       {{"size", vector, "The lengths of its sides.", true},
        {"origin", vector, "Its lower corner. The origin unless given."}}},
      {"disc", "plane; rigid, or filled by SPH", round_keys(false, false, false)},
      {"sphere", "in space; rigid, or filled by SPH", round_keys(false, false, false)},
      {"mesh",
       "linear quadrilaterals or hexahedra of a Gmsh file",
       {{"file", "a text: the path of a .msh file, from the scene's folder", "Versions 1 to 4.1.", true},
        {"unit", "a text: a unit of length, such as \"mm\"", "Of the file's coordinates.", true},
        {"pieces", key_holds::count, "How many pieces it has, joined by sides of cells. 1 unless given."},
        {"open_seams", key_holds::flag, "Sides that lie on each other without shared vertices are meant."}}},
      {"ring", "plane", round_keys(true, false, true)},
      {"cylinder", "in space", round_keys(false, true, true)},
      {"tube", "in space", round_keys(true, true, true)},
      {"quadrilateral", "plane, convex", {}},
      {"ball",
       "in space, with cells of its own",
       {{"centre", vector, "The centre.", true},
        {"radius", key_holds::quantity(dimension::length), "The radius.", true},
        {"axis", axes, "The axis through its poles. \"z\" unless given."},
        {"part", parts, "As of a ring. \"whole\" unless given."},
        {"finer", key_holds::number,
         "How many times finer the cells are at the pole where the axis begins, 1 to 20. SPH takes only "
         "1."}}}};
  for (const char* corner : {"corner1", "corner2", "corner3", "corner4"})
    all[7].keys.push_back({corner, vector, "Counterclockwise from the lower left.", true});
  return all;
}

}  // namespace

KeyTable material_keys() {
  const auto laws = law_entries();
  return {"[materials.NAME]",
          "A material; NAME is what bodies and bars call it.",
          {{"law", key_holds::words(laws), "The constitutive law.", true},
           {"young", key_holds::quantity(dimension::pressure), "Young's modulus E.", true},
           {"poisson", key_holds::number, "Poisson's ratio, above -1 and below 0.5.", true},
           {"density", key_holds::quantity(dimension::density), "At the start.", true}},
          "law",
          laws,
          true};
}

KeyTable johnson_cook_keys() {
  const std::string temperature = key_holds::quantity(dimension::temperature);
  return {
      "[materials.NAME.johnson_cook]",
      "Of a plastic material, in place of \"hardening\": the yield stress is (A + B p^n) (1 + C ln(rate / "
      "reference_rate)) (1 - T*^m), T* = (T - room) / (melting - room). Without \"melting\" heat has no "
      "effect.",
      {{"B", key_holds::quantity(dimension::pressure), "The coefficient of hardening.", true},
       {"n", key_holds::number, "The exponent of the plastic strain p, above 0 and at most 1.", true},
       {"C", key_holds::number, "The coefficient of the strain rate, 0 to 1. 0 unless given."},
       {"reference_rate", key_holds::quantity(dimension::rate),
        "The plastic strain rate at which C adds nothing.", false, "with C above 0"},
       {"melting", temperature, "The melting temperature."},
       {"m", key_holds::number, "The exponent of the temperature, up to 10.", false, "with \"melting\""},
       {"room", temperature, "The temperature at which A, B and n were measured.", false, "with \"melting\""},
       {"temperature", temperature, "At the start. \"room\" unless given."},
       {"heat_capacity", key_holds::quantity(dimension::heat_capacity), "Per mass.", false,
        "with \"melting\""},
       {"heat_share", key_holds::number,
        "The share of the plastic work that turns to heat, 0 to 1. 0.9 unless given."}}};
}

KeyTable body_keys() {
  const auto shapes = shape_entries();
  return {"[bodies.NAME]",
          "A body; NAME is what other tables and columns call it.",
          {{"shape", key_holds::words(shapes), "Its shape at the start.", true},
           {"material", "a text: the name of a material", "What it is made of.", false,
            "unless the body is rigid"},
           {"thickness", key_holds::quantity(dimension::length), "Out of the plane; only in a plane scene.",
            false, "of a body that deforms, and of a rigid one with \"density\", in a plane scene"},
           {"rigid", key_holds::flag, "The body moves and turns as a whole. false unless given."},
           {"mass", key_holds::quantity(dimension::mass), "Of a rigid body.", false,
            "of a rigid body without \"density\""},
           {"density", key_holds::quantity(dimension::density), "Of a rigid body, in place of \"mass\"."}},
          "shape",
          shapes,
          true};
}

KeyTable symmetry_keys() {
  return {"[[symmetry]]",
          "A plane side of a body beyond which the body goes on, mirrored.",
          {body_key(),
           {"at", "a text: a side of the bounding box, such as \"x-\"", "Its normal displacement is zero.",
            true}}};
}

KeyTable bar_keys() {
  const std::string end = "An end, in the undeformed body; bars run along an axis.";
  return {"[bars.NAME]",
          "Reinforcement along an axis, bonded to its body.",
          {body_key(),
           {"from", key_holds::vector(dimension::length), end, true},
           {"to", key_holds::vector(dimension::length), end, true},
           {"area", key_holds::quantity(dimension::area),
            "Of the section: of all bars over the thickness of a plane body, of one in space.", true},
           {"material", "a text: the name of a material", "What the bar is made of.", true}}};
}

}  // namespace femsph::scene_reader
