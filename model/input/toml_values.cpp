// Fields: the values of keys, each checked and in SI.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/input/lookup.hpp"
#include "model/input/toml_fields.hpp"

namespace femsph {
namespace {

bool has_sign(double value, Sign sign) {
  return sign == Sign::any || value > 0 || (sign == Sign::not_negative && value == 0);
}

// Integers are accepted as numbers: rate = 1 as well as rate = 1.0.
std::optional<double> finite_number(const toml::node& node) {
  if (!node.is_number()) return {};
  const double value = *node.value<double>();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string list_such_as(const Dimension& dimension) {
  return fmt::format("a list such as [\"{0}\", \"{0}\"]", dimension.example);
}

}  // namespace

std::optional<std::string> Fields::text(const char* key, Need need, const std::string& expected) {
  return text_of(key, need, expected, {key_holds::text});
}

std::optional<std::string> Fields::text_of(const char* key, Need need, const std::string& expected,
                                           const std::vector<std::string>& held) {
  const toml::node* node = find(key, need, expected, held);
  if (!node) return {};
  if (node->is_string()) return node->as_string()->get();
  wrong_type(*node, key, expected);
  return {};
}

std::optional<std::vector<std::string>> Fields::texts(const char* key, Need need,
                                                      const std::string& expected) {
  const toml::array* list = array(key, need, expected, {key_holds::texts});
  if (!list) return {};
  std::vector<std::string> all;
  for (const toml::node& node : *list) {
    if (!node.is_string()) return wrong_type(node, key, expected), std::nullopt;
    all.push_back(node.as_string()->get());
  }
  return all;
}

std::optional<double> Fields::number(const char* key, Need need, const std::string& expected) {
  const toml::node* node = find(key, need, expected, {key_holds::number});
  if (!node) return {};
  const auto value = finite_number(*node);
  if (node->is_number() && !value)
    return fault(key, fmt::format("\"{}\" is not finite; expected {}", key, expected)), std::nullopt;
  if (!value) wrong_type(*node, key, expected);
  return value;
}

std::optional<std::vector<double>> Fields::numbers(const char* key, Need need) {
  const std::string expected = "a list of finite numbers";
  const toml::array* list = array(key, need, expected, {key_holds::numbers});
  if (!list) return {};
  std::vector<double> all;
  for (const toml::node& node : *list) {
    const auto value = finite_number(node);
    if (!value)
      return faults_->add(source_of(node), fmt::format("not a number in \"{}\"; expected {}", key, expected)),
             std::nullopt;
    all.push_back(*value);
  }
  return all;
}

std::optional<bool> Fields::flag(const char* key, Need need) {
  const toml::node* node = find(key, need, "true or false", {key_holds::flag});
  if (!node) return {};
  if (node->is_boolean()) return node->as_boolean()->get();
  wrong_type(*node, key, "true or false");
  return {};
}

std::optional<int> Fields::count(const char* key, Need need, int least, int most) {
  const std::string expected = fmt::format("a whole number from {} to {}", least, most);
  const toml::node* node = find(key, need, expected, {key_holds::count});
  if (!node) return {};
  if (!node->is_integer()) return wrong_type(*node, key, expected), std::nullopt;
  const auto value = node->as_integer()->get();
  if (value >= least && value <= most) return int(value);
  fault(key, fmt::format("\"{}\" is {}; expected {}", key, value, expected));
  return {};
}

std::optional<double> Fields::read_quantity(const toml::node& node, const char* key,
                                            const Dimension& dimension, Sign sign) {
  if (!node.is_string()) return wrong_type(node, key, expected_quantity(dimension)), std::nullopt;
  try {
    const double value = to_si(node.as_string()->get(), dimension);
    if (has_sign(value, sign)) return value;
    faults_->add(source_of(node),
                 fmt::format("\"{}\" is {}; expected {} {}", key, node.as_string()->get(), dimension.name,
                             sign == Sign::positive ? "greater than zero" : "zero or greater"));
  } catch (const std::invalid_argument& e) {
    faults_->add(source_of(node), fmt::format("\"{}\": {}", key, e.what()));
  }
  return {};
}

std::optional<double> Fields::quantity(const char* key, Need need, const Dimension& dimension, Sign sign) {
  const toml::node* node = find(key, need, expected_quantity(dimension), {key_holds::quantity(dimension)});
  return node ? read_quantity(*node, key, dimension, sign) : std::nullopt;
}

std::optional<std::vector<double>> Fields::quantities(const char* key, Need need, const Dimension& dimension,
                                                      Sign sign) {
  const toml::array* list = array(key, need, list_such_as(dimension), {key_holds::quantities(dimension)});
  return list ? read_quantities(*list, key, dimension, sign) : std::nullopt;
}

std::optional<std::vector<double>> Fields::read_quantities(const toml::array& list, const char* key,
                                                           const Dimension& dimension, Sign sign) {
  std::vector<double> all;
  for (const toml::node& node : list)
    if (const auto value = read_quantity(node, key, dimension, sign)) all.push_back(*value);
  return all.size() == list.size() ? std::optional(all) : std::nullopt;
}

std::optional<Point> Fields::vector(const char* key, Need need, const Dimension& dimension, int dim,
                                    Sign sign) {
  const toml::array* list = array(key, need, list_such_as(dimension), {key_holds::vector(dimension)});
  const auto all = list ? read_quantities(*list, key, dimension, sign) : std::nullopt;
  return all ? to_point(*all, key, dim) : std::nullopt;
}

std::optional<std::array<Point, 3>> Fields::matrix(const char* key, Need need, const Dimension* dimension,
                                                   int dim) {
  const std::string value = dimension ? fmt::format("\"{}\"", dimension->example) : "0.1";
  const std::string row = dim == 3 ? fmt::format("[{0}, {0}, {0}]", value) : fmt::format("[{0}, {0}]", value);
  const std::string expected = dim == 3 ? fmt::format("three rows such as [{0}, {0}, {0}]", row)
                                        : fmt::format("two rows such as [{0}, {0}]", row);
  const toml::array* list = array(key, need, expected, {key_holds::matrix(dimension)});
  if (!list) return {};
  const bool fits = dim == 0 ? list->size() == 2 || list->size() == 3 : int(list->size()) == dim;
  if (!fits || !std::all_of(list->begin(), list->end(), [](const toml::node& n) { return n.is_array(); }))
    return fault(key, fmt::format("\"{}\" is no square matrix; expected {}", key, expected)), std::nullopt;
  std::array<Point, 3> rows{};
  bool good = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::array& line = *(*list)[i].as_array();
    if (line.size() != list->size())
      return fault(key, fmt::format("\"{}\" is no square matrix; expected {}", key, expected)), std::nullopt;
    for (std::size_t j = 0; j < line.size(); ++j) {
      const auto number = dimension ? read_quantity(line[j], key, *dimension, Sign::any)
                                    : finite_number(line[j]);
      if (!number && !dimension)
        faults_->add(source_of(line[j]), fmt::format("not a number in \"{}\"; expected {}", key, expected));
      good = good && number;
      rows[i][j] = number.value_or(0);
    }
  }
  return good ? std::optional(rows) : std::nullopt;
}

std::optional<std::pair<Point, Point>> Fields::corners(const char* key, Need need, const Dimension& dimension,
                                                       int dim) {
  const std::string expected = "two corners such as [[\"0 mm\", \"0 mm\"], [\"50 mm\", \"10 mm\"]]";
  const toml::array* list = array(key, need, expected, {key_holds::corners(dimension)});
  if (!list) return {};
  if (list->size() != 2 || !(*list)[0].is_array() || !(*list)[1].is_array())
    return fault(key, fmt::format("\"{}\" is not a pair of corners; expected {}", key, expected)),
           std::nullopt;
  std::optional<Point> corner[2];
  for (int k = 0; k < 2; ++k)
    if (const auto all = read_quantities(*(*list)[std::size_t(k)].as_array(), key, dimension, Sign::any))
      corner[k] = to_point(*all, key, dim);
  if (!corner[0] || !corner[1]) return {};
  for (int a = 0; a < 3; ++a)
    if ((*corner[0])[a] > (*corner[1])[a])
      return fault(key, fmt::format("the first corner of \"{}\" lies above the second along {}; expected the "
                                    "lower corner first",
                                    key, "xyz"[a])),
             std::nullopt;
  return std::pair(*corner[0], *corner[1]);
}

std::optional<Point> Fields::to_point(const std::vector<double>& all, const char* key, int dim) const {
  const bool fits = dim == 0 ? all.size() == 2 || all.size() == 3 : int(all.size()) == dim;
  if (!fits) {
    fault(key,
          fmt::format("\"{}\" has {} component{}; expected {}", key, all.size(), all.size() == 1 ? "" : "s",
                      dim == 2   ? "2 (x, y) in a plane scene"
                      : dim == 3 ? "3 (x, y, z) in a three-dimensional scene"
                                 : "2 or 3"));
    return {};
  }
  Point point{};
  std::copy(all.begin(), all.end(), point.begin());
  return point;
}

std::optional<std::size_t> Fields::choose(const char* key, Need need, const std::vector<std::string>& words) {
  std::vector<std::string> held;
  for (const std::string& word : words) held.push_back(in_quotes(word));
  const auto word = text_of(key, need, one_of(words), held);
  if (!word) return {};
  const auto found = std::find(words.begin(), words.end(), *word);
  if (found != words.end()) return found - words.begin();
  fault(key, fmt::format("\"{}\" is {}{}", key, in_quotes(*word), expected_names(*word, words)));
  return {};
}

}  // namespace femsph
