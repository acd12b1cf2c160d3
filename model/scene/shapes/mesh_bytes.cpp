#include "model/scene/shapes/mesh_bytes.hpp"

#include <cstring>

namespace femsph {
namespace {

template <class T>
void put(std::string& bytes, const std::vector<T>& list) {
  const std::size_t n = list.size();
  bytes.append(reinterpret_cast<const char*>(&n), sizeof n);
  if (n > 0) bytes.append(reinterpret_cast<const char*>(list.data()), n * sizeof(T));
}

template <class T>
std::vector<T> take(const std::string& bytes, std::size_t& at) {
  std::size_t n = 0;
  std::memcpy(&n, bytes.data() + at, sizeof n);
  std::vector<T> list(n);
  if (n > 0)
    std::memcpy(list.data(), bytes.data() + at + sizeof n,
                n * sizeof(T));  // an empty list may hold no address
  at += sizeof n + n * sizeof(T);
  return list;
}

void put(std::string& bytes, const std::string& text) {
  put(bytes, std::vector<char>(text.begin(), text.end()));
}

std::string take_text(const std::string& bytes, std::size_t& at) {
  const std::vector<char> text = take<char>(bytes, at);
  return {text.begin(), text.end()};
}

}  // namespace

std::string to_bytes(const CellMesh& mesh) {
  std::string bytes;
  put(bytes, mesh.vertices);
  put(bytes, mesh.cells);
  put(bytes, mesh.facets);
  put(bytes, mesh.cell_numbers);
  put(bytes, mesh.vertex_numbers);
  put(bytes,
      std::vector<std::size_t>{mesh.groups.size(), mesh.group_words.size(), mesh.unusable_words.size()});
  for (const std::string& group : mesh.groups) put(bytes, group);
  for (const auto& [word, group] : mesh.group_words) put(bytes, word), put(bytes, std::vector<int>{group});
  for (const auto& [word, why] : mesh.unusable_words) put(bytes, word), put(bytes, why);
  return bytes;
}

CellMesh from_bytes(const std::string& bytes, std::size_t at, int dim) {
  CellMesh mesh;
  mesh.dim = dim;
  mesh.vertices = take<Point>(bytes, at);
  mesh.cells = take<std::array<int, 8>>(bytes, at);
  mesh.facets = take<CellMesh::Facet>(bytes, at);
  mesh.cell_numbers = take<std::size_t>(bytes, at);
  mesh.vertex_numbers = take<std::size_t>(bytes, at);
  const auto counts = take<std::size_t>(bytes, at);
  for (std::size_t i = 0; i < counts[0]; ++i) mesh.groups.push_back(take_text(bytes, at));
  for (std::size_t i = 0; i < counts[1]; ++i) {
    const std::string word = take_text(bytes, at);
    mesh.group_words.emplace_back(word, take<int>(bytes, at)[0]);
  }
  for (std::size_t i = 0; i < counts[2]; ++i) {
    const std::string word = take_text(bytes, at);
    mesh.unusable_words.emplace_back(word, take_text(bytes, at));
  }
  return mesh;
}

}  // namespace femsph
