#pragma once
// A mesh as bytes, to pass it from the process that reads the file to the program: the length of each list,
// then its entries.

#include <string>

#include "model/scene/shapes/shape.hpp"

namespace femsph {

std::string to_bytes(const CellMesh& mesh);
/// The mesh in the bytes from `at` on, as to_bytes() has written them.
CellMesh from_bytes(const std::string& bytes, std::size_t at, int dim);

}  // namespace femsph
