#include "model/scene/shapes/round_frame.hpp"

#include "model/input/toml_fields.hpp"

namespace femsph {

namespace {

const std::vector<std::pair<std::string, RoundPart>> round_parts = {
    {"whole", RoundPart::whole}, {"half", RoundPart::half}, {"quarter", RoundPart::quarter}};
const std::vector<std::pair<std::string, int>> round_axes = {{"x", 0}, {"y", 1}, {"z", 2}};

}  // namespace

Key centre_key(const std::string& about) {
  return {"centre", key_holds::vector(dimension::length), about, true};
}

Key radius_key() { return {"radius", key_holds::quantity(dimension::length), "The radius.", true}; }

Key part_key() {
  return {"part", key_holds::words(round_parts),
          "How much of it there is. The section has two axes, which follow the shape's axis cyclically: x "
          "and y if that is z, or in a plane. \"half\" is where the second of them is above the centre, "
          "\"quarter\" where both are. \"whole\" unless given."};
}

Key axis_key(const std::string& about, bool required) {
  return {"axis", key_holds::words(round_axes), about, required};
}

std::optional<RoundPart> read_part(Fields& body) { return body.choice("part", Need::optional, round_parts); }

std::optional<int> read_axis(Fields& body, Need need) { return body.choice("axis", need, round_axes); }

}  // namespace femsph
