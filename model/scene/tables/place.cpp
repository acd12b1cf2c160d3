// Part of a body: "at" names sides of its shape, or "point" the discretization point nearest to it.

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "model/scene/reader/scene_page.hpp"
#include "model/scene/reader/scene_reader.hpp"

namespace femsph::scene_reader {
namespace {

const std::string whole_body = "all";

bool opposite(const std::string& a, const std::string& b) {
  return a.size() == 2 && b.size() == 2 && a[0] == b[0] && a[1] != b[1];
}

// Sides meet where a point lies on all of them. The cells of a shape that has some show whether there is one
// (an L-shape has no corner where x+ and y+ meet); the bounding sides of a convex shape meet unless they face
// each other.
bool meet(const Shape& shape, const std::vector<std::string>& sides) {
  const CellMesh* mesh = shape.cells();
  if (!mesh) {
    for (const auto& a : sides)
      for (const auto& b : sides)
        if (opposite(a, b)) return false;
    return true;
  }
  const double tolerance = point_tolerance(shape);
  return std::any_of(mesh->vertices.begin(), mesh->vertices.end(), [&](const Point& p) {
    return std::all_of(sides.begin(), sides.end(),
                       [&](const std::string& side) { return shape.on_side(side, p, tolerance); });
  });
}

/// A word for a side, as the shape calls it: a side's own name, or a group of a mesh by its name or number.
/// Nothing if it is none.
std::optional<std::string> side_named(const Shape& shape, const std::string& word) {
  const std::vector<std::string> sides = shape.sides();
  if (const CellMesh* mesh = shape.cells())
    for (const auto& [said, group] : mesh->group_words)
      if (said == word) return mesh->groups[std::size_t(group)];
  const bool known = std::find(sides.begin(), sides.end(), word) != sides.end();
  return known ? std::optional(word) : std::nullopt;
}

/// Why a name or number that the mesh file holds is no side; nothing if the file does not hold it.
std::optional<std::string> in_vain(const Shape& shape, const std::string& word) {
  if (const CellMesh* mesh = shape.cells())
    for (const auto& [said, why] : mesh->vain_words)
      if (said == word) return why;
  return {};
}

/// "at" word by word; a physical name may hold blanks, so that the whole of "at" is one. Words that could be
/// read in both ways are refused.
std::optional<std::vector<std::string>> words_of(const Fields& fields, const std::string& at,
                                                 const Shape& shape) {
  std::vector<std::string> words;
  std::istringstream stream(at);
  for (std::string word; stream >> word;) words.push_back(word);
  if (words.size() < 2 || (!side_named(shape, at) && !in_vain(shape, at))) return words;
  if (std::all_of(words.begin(), words.end(), [&](const std::string& word) {
        return side_named(shape, word) || in_vain(shape, word) || word == whole_body;
      }))
    return fields.fault("at", fmt::format("{} is the name of a physical group, and several sides; expected "
                                          "the group's number, or another name for it",
                                          in_quotes(at))),
           std::nullopt;
  return std::vector<std::string>{at};
}

std::optional<std::vector<std::string>> read_sides(const Fields& fields, const std::string& at,
                                                   const Shape& shape) {
  std::vector<std::string> sides, known = shape.sides();
  known.push_back(whole_body);
  const auto words = words_of(fields, at, shape);
  if (!words) return {};
  for (const std::string& word : *words) {
    if (const auto why = in_vain(shape, word)) return fields.fault("at", *why), std::nullopt;
    const std::optional<std::string> side = word == whole_body ? word : side_named(shape, word);
    if (!side)
      return fields.fault("at", fmt::format("unknown side {}; expected {}{}", in_quotes(word), one_of(known),
                                            did_you_mean(word, known))),
             std::nullopt;
    if (std::find(sides.begin(), sides.end(), *side) != sides.end())
      return fields.fault(
                 "at", fmt::format("side {} is given twice; expected each side once", in_quotes(word))),
             std::nullopt;
    sides.push_back(*side);
  }
  if (sides.empty())
    return fields.fault("at", fmt::format("\"at\" is empty; expected {}", one_of(known))), std::nullopt;
  if (std::find(sides.begin(), sides.end(), whole_body) != sides.end()) {
    if (sides.size() > 1)
      return fields.fault("at", "\"all\" is given with other sides; expected \"all\" alone or sides alone"),
             std::nullopt;
    return std::vector<std::string>{};
  }
  if (meet(shape, sides)) return sides;
  fields.fault("at", fmt::format("the sides {} do not meet; expected sides with a common {}", in_quotes(at),
                                 shape.dim() == 3 ? "edge or corner" : "corner"));
  return {};
}

}  // namespace

Key body_key() {
  return {"body", "a text: the name of a body", "Which body.", false, "where the scene has several bodies"};
}

std::vector<Key> place_keys() {
  return {
      body_key(),
      {"at", "a text: sides of the body's shape, or \"all\"",
       "\"x-\" is a side, \"x+ y+\" is where two sides meet, \"all\" the whole body; a physical group of a "
       "mesh goes by its name or number.",
       false, "unless \"point\" is given or the body is rigid"},
      {"point", key_holds::vector(dimension::length),
       "In place of \"at\": the node or particle nearest to this point of the undeformed body."},
      {"within", key_holds::corners(dimension::length),
       "Of \"at\" only the points in the box between these corners, the lower one first."}};
}

std::optional<Place> read_place(Fields& fields, const Reading& reading) {
  const std::string expected = "at = \"x-\" (sides, or \"all\") or point = [..] (the nearest point)";
  const auto body = read_body_of(fields, reading);
  const bool both = fields.has("at") && fields.has("point");
  const bool by_point = fields.has("point");
  const bool rigid = body && reading.scene.bodies[*body].rigid;
  // A body without a material is rigid, or a fault hides what it is.
  const bool needs_at = !by_point && body && !reading.scene.bodies[*body].material.empty();
  const auto at = fields.text("at", needs_at ? Need::required : Need::optional, expected);
  const auto point = fields.vector("point", Need::optional, dimension::length, reading.dim);
  const auto within = fields.corners("within", Need::optional, dimension::length, reading.dim);
  if (both)
    return fields.fault("point", "both \"at\" and \"point\" are given; expected one of them"), std::nullopt;
  if (rigid) {
    if (point || at.value_or(whole_body) != whole_body)
      return fields.fault(
                 by_point ? "point" : "at",
                 fmt::format("part of body {}, which is rigid; expected \"all\", which stands for its centre",
                             in_quotes(reading.scene.bodies[*body].name))),
             std::nullopt;
    return Place{*body, {}, {}, fields.source("body")};
  }
  if (!body || (!at && !point)) return {};

  Place place;
  place.body = *body;
  place.point = point;
  if (within) place.within = Region{within->first, within->second};
  if (point && fields.has("within"))
    fields.fault("within", "\"within\" with \"point\"; expected it only with \"at\"");
  place.source = fields.source(by_point ? "point" : "at");
  const Shape* shape = reading.scene.bodies[*body].shape.get();
  if (!shape) return place;
  if (point) return require_inside(fields, "point", *point, *body, reading), place;
  const auto sides = read_sides(fields, *at, *shape);
  if (!sides) return {};
  place.sides = *sides;
  return place;
}

}  // namespace femsph::scene_reader
