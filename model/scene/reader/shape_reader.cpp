#include "model/scene/reader/shape_reader.hpp"

namespace femsph {

ShapePointer read_shape(Fields& body, int dim, const std::filesystem::path& folder) {
  std::vector<std::pair<std::string, const ShapeEntry*>> words;
  for (const ShapeEntry& shape : shapes()) words.emplace_back(shape.entry.word, &shape);
  const auto chosen = body.choice<const ShapeEntry*>("shape", Need::required, words);
  if (chosen) return (*chosen)->read(body, dim, folder);
  body.accept_rest();
  return nullptr;
}

}  // namespace femsph
