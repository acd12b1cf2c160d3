#pragma once

#include "model/scene/shapes/shape.hpp"

namespace femsph {

/// A shape that knows how to cut itself into quadrilaterals or hexahedra of a wanted size.
class StructuredShape : public Shape {
 public:
  /// Cells of about (upper - lower) / divisions along each axis; throws std::runtime_error with one sentence
  /// when that is none.
  virtual CellMesh mesh(const std::array<int, 3>& divisions) const = 0;
  /// The key that makes those cells of many sizes in this body; empty: they are even.
  virtual std::string graded_by() const { return ""; }
  const StructuredShape* structured() const final { return this; }
  std::optional<CellMesh> cut(const std::array<int, 3>& divisions) const final { return mesh(divisions); }
};

}  // namespace femsph
