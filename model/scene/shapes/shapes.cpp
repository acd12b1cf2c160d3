#include "model/scene/shapes/shapes.hpp"

namespace femsph {

// Each stands in the file of its shape.
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

}  // namespace femsph
