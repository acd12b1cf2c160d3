#pragma once
// A mesh as bytes, from the process that reads it to the one that wants it: the lengths of its lists, then
// what they hold.

#include <string>

#include "model/scene/shapes/shape.hpp"

namespace femsph {

std::string to_bytes(const CellMesh& mesh);
/// The bytes from `at` on, as to_bytes wrote them.
CellMesh from_bytes(const std::string& bytes, std::size_t at, int dim);

}  // namespace femsph
