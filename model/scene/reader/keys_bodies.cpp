// The keys of materials and bodies.

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
          "A material. Bodies and bars refer to it by NAME.",
          {{"law", key_holds::words(laws), "The constitutive law; each law has further keys, below.", true},
           {"young", key_holds::quantity(dimension::pressure), "Young's modulus E.", false,
            "unless law = \"fluid\""},
           {"poisson", key_holds::number, "Poisson's ratio, above -1 and below 0.5.", false,
            "unless law = \"fluid\""},
           {"density", key_holds::quantity(dimension::density), "Mass density of the undeformed material.",
            true}},
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
  return {
      "[bodies.NAME]",
      "A body. Other tables, and columns of the results, refer to it by NAME.",
      {{"shape", key_holds::words(shapes),
        "The shape of the undeformed body; each shape has further keys, below.", true},
       {"material", "a text: the name of a material", "The material of the body.", false,
        "unless the body is rigid"},
       {"thickness", key_holds::quantity(dimension::length),
        "The thickness normal to the plane. Only in a plane scene.", false,
        "of a body that deforms, and of a rigid one with \"density\", in a plane scene"},
       {"rigid", key_holds::flag,
        "true: the body does not deform; it translates and rotates as a whole. false unless given."},
       {"mass", key_holds::quantity(dimension::mass),
        "The mass of a rigid body. Of half a body (symmetry) give half the mass.", false,
        "of a rigid body without \"density\""},
       {"density", key_holds::quantity(dimension::density),
        "The density of a rigid body, instead of its mass."}},
      "shape",
      shapes,
      true};
}

}  // namespace femsph::scene_reader
