#pragma once

#include "model/scene/shapes/shape.hpp"

namespace femsph {

/// A shape that cuts itself into quadrilaterals or hexahedra of a given size.
class StructuredShape : public Shape {
 public:
  /// Cells of about the size (upper - lower) / divisions along each axis. Throws std::runtime_error if a
  /// number of divisions is below 1.
  virtual CellMesh mesh(const std::array<int, 3>& divisions) const = 0;
  /// The key of the scene that makes the cells different in size, if it is used; else empty.
  virtual std::string graded_by() const { return ""; }
  const StructuredShape* structured() const final { return this; }
  std::optional<CellMesh> cut(const std::array<int, 3>& divisions) const final { return mesh(divisions); }
};

}  // namespace femsph
