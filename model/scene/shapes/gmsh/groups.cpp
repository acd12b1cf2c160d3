// Physical groups of a mesh: which words a place can use for them, and why others cannot be used. An
// ambiguous word is an error only if a place uses it.

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "model/input/faults.hpp"
#include "model/scene/shapes/gmsh/api.hpp"
#include "model/scene/shapes/mesh_sides.hpp"

namespace femsph::gmsh_reader {
namespace {

const char* kind_of(int dim, int mesh_dim) {
  if (dim == mesh_dim) return "cells";
  return dim == 0 ? "points" : dim == 1 ? "lines" : "faces";
}

struct Group {
  int dim = 0, tag = 0;
  bool known = false;                   // it has entities, and not only a name
  std::vector<CellMesh::Facet> facets;  // only for groups of sides
  std::vector<std::size_t> numbers;     // numbers of their elements in the file
  std::string fault;                    // why a place cannot use it; empty: it can
  std::string number() const { return std::to_string(tag); }
};

std::string text_of(const Group& group, const std::string& file) {
  return fmt::format("physical group {} of {}", group.tag, in_quotes(file));
}

// Adds the elements of a block that belong to this group.
void add_facets(Group& group, const Block& block, const std::function<bool(std::size_t)>& listed,
                const CellMesh& mesh, const Vertices& vertices, const std::string& file) {
  const int corners = corners_of(block.type);
  for (std::size_t i = 0; i < block.numbers.size() && group.fault.empty(); ++i) {
    if (!listed(block.numbers[i])) continue;
    if (block.type != (mesh.dim == 2 ? gmsh_line : gmsh_quad)) {
      group.fault = fmt::format("{} holds facets of type {}; expected linear {}", text_of(group, file),
                                type_name(block.type), mesh.dim == 2 ? "lines" : "quadrilaterals");
      return;
    }
    CellMesh::Facet facet{{-1, -1, -1, -1}, -1};
    for (int v = 0; v < corners; ++v)
      facet.vertices[around_to_lexicographic[v]] = vertices.used(block.nodes[i * corners + v]);
    group.facets.push_back(facet);
    group.numbers.push_back(block.numbers[i]);
  }
}

// Versions 1 and 2 list the group of each element. Gmsh assigns groups to entities, so that two groups of one
// entity would become one; therefore the list in the file is used. Later versions assign groups to entities.
void read_facets(std::vector<Group>& groups, const CellMesh& mesh, const Vertices& vertices,
                 const MshFacts& facts, const std::string& file) {
  std::unordered_map<std::size_t, int> listed;
  for (std::size_t i = 0; i < facts.groups.size(); ++i)
    listed[facts.numbers[i]] = std::abs(facts.groups[i]);  // the sign is the orientation of the element
  const std::vector<Block> all = facts.lists_groups() ? elements(mesh.dim - 1) : std::vector<Block>{};
  for (Group& group : groups) {
    if (group.dim != mesh.dim - 1) continue;
    const auto in_group = [&](std::size_t number) {
      const auto found = listed.find(number);
      return found != listed.end() && found->second == group.tag;
    };
    for (const Block& block : all) add_facets(group, block, in_group, mesh, vertices, file);
    std::vector<int> entities;
    if (!facts.lists_groups() && group.known)
      gmsh::model::getEntitiesForPhysicalGroup(group.dim, group.tag, entities);
    for (const int entity : entities)
      for (const Block& block : elements(group.dim, entity))
        add_facets(
            group, block, [](std::size_t) { return true; }, mesh, vertices, file);
    if (group.facets.empty() && group.fault.empty())
      group.fault = fmt::format("{} holds no elements; expected sides of cells", text_of(group, file));
  }
}

// A facet that is not a side of a cell cannot be loaded or fixed.
void require_sides_of_cells(std::vector<Group>& groups, const CellMesh& mesh, const std::string& file) {
  std::map<SideKey, bool> known;  // of each facet: whether it is a side of a cell
  for (const Group& group : groups)
    for (const auto& facet : group.facets) known[side_key(facet.vertices, mesh.dim)] = false;
  if (known.empty()) return;
  for_each_side(mesh, [&](int, const std::array<int, 4>& loop) {
    const auto found = known.find(side_key(loop, mesh.dim));
    if (found != known.end()) found->second = true;
  });
  for (Group& group : groups)
    for (std::size_t i = 0; i < group.facets.size() && group.fault.empty(); ++i)
      if (!known[side_key(group.facets[i].vertices, mesh.dim)])
        group.fault = fmt::format(
            "{} holds element {}, which is the side of no cell; expected sides of cells alone",
            text_of(group, file), group.numbers[i]);
}

std::vector<Group> read_all(const CellMesh& mesh, const Vertices& vertices, const MshFacts& facts,
                            const std::string& file) {
  gmsh::vectorpair pairs;
  gmsh::model::getPhysicalGroups(pairs);
  std::set<std::pair<int, int>> all(pairs.begin(), pairs.end());
  for (const auto& name : facts.names) all.insert({name.dim, name.tag});
  std::vector<Group> groups;
  for (const auto& [dim, tag] : all) {
    Group group;
    group.dim = dim, group.tag = tag;
    group.known = std::find(pairs.begin(), pairs.end(), std::pair(dim, tag)) != pairs.end();
    if (dim != mesh.dim - 1)
      group.fault = fmt::format(
          "{} holds {} and no sides of cells; expected a group of {}", text_of(group, file),
          kind_of(dim, mesh.dim), kind_of(mesh.dim - 1, mesh.dim));
    groups.push_back(std::move(group));
  }
  read_facets(groups, mesh, vertices, facts, file);
  require_sides_of_cells(groups, mesh, file);
  return groups;
}

/// The words for places of every shape: sides of the bounding box, and "all".
std::vector<std::string> words_of_shapes(int dim) {
  std::vector<std::string> words = {"x-", "x+", "y-", "y+", "z-", "z+"};
  words.resize(2 * dim);
  words.push_back("all");
  return words;
}

// A group with the name of a side of the bounding box that is exactly that side is not ambiguous.
bool is_that_side(const Group& group, const std::string& side, const CellMesh& mesh) {
  if (side == "all" || group.dim != mesh.dim - 1 || !group.fault.empty()) return false;
  const int axis = side[0] - 'x';
  double low = mesh.vertices[0][axis], high = low;
  for (const Point& p : mesh.vertices) low = std::min(low, p[axis]), high = std::max(high, p[axis]);
  std::vector<char> in_group(mesh.vertices.size());
  for (const auto& facet : group.facets)
    for (int v = 0; v < 1 << (mesh.dim - 1); ++v) in_group[facet.vertices[v]] = 1;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (in_group[v] !=
        (std::abs(mesh.vertices[v][axis] - (side[1] == '-' ? low : high)) <= 1e-6 * (high - low)))
      return false;
  return true;
}

std::string list_of(const std::set<int>& meanings, const std::vector<Group>& groups, int dim) {
  std::string text;
  std::size_t left = meanings.size();
  for (const int g : meanings) {
    text += fmt::format("{} ({})", groups[g].tag, kind_of(groups[g].dim, dim));
    if (--left) text += left == 1 ? " and " : ", ";
  }
  return text;
}

}  // namespace

void read_groups(CellMesh& mesh, const Vertices& vertices, const MshFacts& facts, const std::string& file) {
  const std::vector<Group> groups = read_all(mesh, vertices, facts, file);
  std::map<std::string, std::set<int>> meanings;  // of each word: the indices of the groups that it may mean
  std::vector<std::string> name(groups.size());
  for (int g = 0; g < int(groups.size()); ++g) {
    std::set<std::string> names;
    for (const auto& line : facts.names)
      if (line.dim == groups[g].dim && line.tag == groups[g].tag && !line.text.empty())
        names.insert(line.text), meanings[line.text].insert(g);
    if (names.size() == 1) name[g] = *names.begin();
    if (groups[g].dim == mesh.dim - 1) meanings[groups[g].number()].insert(g);
    for (const std::string& word : names)
      if (names.size() > 1)
        mesh.unusable_words.emplace_back(
            word, fmt::format("{} is one of several names of {}; expected its number, \"{}\"",
                              in_quotes(word), text_of(groups[g], file), groups[g].tag));
  }
  const auto is_unusable = [&](const std::string& word) {
    return std::any_of(mesh.unusable_words.begin(), mesh.unusable_words.end(),
                       [&](const auto& unusable) { return unusable.first == word; });
  };
  const std::vector<std::string> standing = words_of_shapes(mesh.dim);
  std::map<std::string, int> meant;  // of each usable word: the index of its group
  for (const auto& [word, of] : meanings) {
    const Group& first = groups[*of.begin()];
    if (is_unusable(word)) continue;
    if (std::find(standing.begin(), standing.end(), word) != standing.end()) {
      if (of.size() == 1 && is_that_side(first, word, mesh)) continue;
      mesh.unusable_words.emplace_back(
          word, fmt::format("{} is {} and, in {}, the name of physical group {}; expected the group's "
                            "number, or another name for it",
                            in_quotes(word), word == "all" ? "the whole body" : "a side of the bounding box",
                            in_quotes(file), list_of(of, groups, mesh.dim)));
    } else if (of.size() > 1) {
      std::vector<std::string> numbers;
      for (const int g : of)
        if (groups[g].dim == mesh.dim - 1) numbers.push_back(groups[g].number());
      mesh.unusable_words.emplace_back(
          word, fmt::format("{} means physical groups {} of {}; expected {}names that differ",
                            in_quotes(word), list_of(of, groups, mesh.dim), in_quotes(file),
                            numbers.empty() ? ""
                                            : fmt::format("the number of a group of {}, {}, or ",
                                                          kind_of(mesh.dim - 1, mesh.dim), one_of(numbers))));
    } else if (!first.fault.empty()) {
      mesh.unusable_words.emplace_back(word, first.fault);
    } else {
      meant[word] = *of.begin();
    }
  }
  for (int g = 0; g < int(groups.size()); ++g) {
    const bool by_name = !name[g].empty() && meant.count(name[g]),
               by_number = meant.count(groups[g].number()) && meant[groups[g].number()] == g;
    if (groups[g].dim != mesh.dim - 1 || (!by_name && !by_number)) continue;
    const int index = int(mesh.groups.size());
    mesh.groups.push_back(by_name ? name[g] : groups[g].number());
    if (by_name) mesh.group_words.emplace_back(name[g], index);
    if (by_number && name[g] != groups[g].number()) mesh.group_words.emplace_back(groups[g].number(), index);
    std::set<SideKey> seen;  // a file may list a facet once for each of its groups
    for (CellMesh::Facet facet : groups[g].facets) {
      facet.group = index;
      if (seen.insert(side_key(facet.vertices, mesh.dim)).second) mesh.facets.push_back(facet);
    }
  }
}

}  // namespace femsph::gmsh_reader
