#include "model/scene/shapes/shapes.hpp"

#include "model/input/toml_fields.hpp"

namespace femsph {

// Each is defined in the file of its shape.
ShapeEntry box_entry();
ShapeEntry disc_entry();
ShapeEntry sphere_entry();
ShapeEntry mesh_entry();
ShapeEntry ring_entry();
ShapeEntry cylinder_entry();
ShapeEntry tube_entry();
ShapeEntry quadrilateral_entry();
ShapeEntry ball_entry();

const std::vector<ShapeEntry>& shapes() {
  static const std::vector<ShapeEntry> all = {
      box_entry(),      disc_entry(), sphere_entry(),        mesh_entry(), ring_entry(),
      cylinder_entry(), tube_entry(), quadrilateral_entry(), ball_entry(),
  };
  return all;
}

ShapePointer read_shape(Fields& body, int dim, const std::filesystem::path& folder) {
  std::vector<std::pair<std::string, const ShapeEntry*>> words;
  for (const ShapeEntry& shape : shapes()) words.emplace_back(shape.entry.word, &shape);
  const auto chosen = body.choice<const ShapeEntry*>("shape", Need::required, words);
  if (chosen) return (*chosen)->read(body, dim, folder);
  body.accept_rest();
  return nullptr;
}

}  // namespace femsph
