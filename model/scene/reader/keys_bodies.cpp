// The keys of materials, bodies, symmetry planes and bars.

#include "model/scene/reader/scene_page.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph::scene_reader {
namespace {

std::vector<Entry> law_entries() {
  std::vector<Entry> all;
  for (const LawEntry& law : laws()) all.push_back(law.entry);
  return all;
}

std::vector<Entry> shape_entries() {
  std::vector<Entry> all;
  for (const ShapeEntry& shape : shapes()) all.push_back(shape.entry);
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

std::vector<KeyTable> law_tables() {
  std::vector<KeyTable> all;
  for (const LawEntry& law : laws()) all.insert(all.end(), law.tables.begin(), law.tables.end());
  return all;
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
