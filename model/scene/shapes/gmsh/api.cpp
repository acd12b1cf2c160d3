#include "model/scene/shapes/gmsh/api.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <stdexcept>

#include "model/input/faults.hpp"

namespace femsph::gmsh_reader {

Session::Session() {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::logger::start();
}

Session::~Session() {
  try {
    gmsh::finalize();
  } catch (...) {  // ignored: the mesh has been copied, or an error is being reported
  }
}

std::vector<Block> elements(int dim, int entity) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, nodes;
  gmsh::model::mesh::getElements(types, tags, nodes, dim, entity);
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < types.size(); ++i)
    if (!nodes[i].empty()) blocks.push_back({types[i], std::move(tags[i]), std::move(nodes[i])});
  return blocks;
}

namespace {

struct ElementType {
  std::string name;
  int nodes = 0;
};

ElementType properties_of(int type) {
  ElementType properties;
  int dim, order, primary;
  std::vector<double> coordinates;
  gmsh::model::mesh::getElementProperties(
      type, properties.name, dim, order, properties.nodes, coordinates, primary);
  return properties;
}

}  // namespace

std::string type_name(int type) { return in_quotes(properties_of(type).name); }
int corners_of(int type) { return properties_of(type).nodes; }

Vertices::Vertices(double unit, const std::string& file) : file_(file) {
  std::vector<std::size_t> tags;
  std::vector<double> x, parametric;
  gmsh::model::mesh::getNodes(tags, x, parametric, -1, -1, false, false);
  for (std::size_t i = 0; i < tags.size(); ++i)
    place_[tags[i]] = {x[3 * i] * unit, x[3 * i + 1] * unit, x[3 * i + 2] * unit};
}

int Vertices::use(std::size_t tag, CellMesh& mesh) {
  const auto place = place_.find(tag);
  if (place == place_.end())
    throw std::runtime_error(fmt::format(
        "a cell of {} uses vertex {}, which the file does not hold; expected a mesh saved by Gmsh",
        in_quotes(file_), tag));
  const auto [number, is_new] = number_.try_emplace(tag, int(mesh.vertices.size()));
  if (is_new) mesh.vertices.push_back(place->second), mesh.vertex_numbers.push_back(tag);
  return number->second;
}

int Vertices::used(std::size_t tag) const {
  const auto number = number_.find(tag);
  return number == number_.end() ? -1 : number->second;
}

}  // namespace femsph::gmsh_reader
