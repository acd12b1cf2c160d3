#include "model/input/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "model/input/faults.hpp"

namespace femsph {
namespace {

using UnitHandle = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;

// Reading the unit database takes milliseconds, so it is read once and kept.
ut_system* unit_system() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    return ut_read_xml(nullptr);
  }();
  if (!system)
    throw std::invalid_argument(
        "the unit database of UDUNITS-2 could not be read (package libudunits2-data)");
  return system;
}

UnitHandle parse_unit(const std::string& text) {
  return {ut_parse(unit_system(), text.c_str(), UT_UTF8), ut_free};
}

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
  while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
  return s;
}

struct Written {
  double number;
  std::string unit;
};

// The number is parsed here, because UDUNITS-2 does not accept zero ("0 N" is no unit), and accepts "1/s" but
// not "/s".
Written split(const std::string& quantity, const std::string& expected) {
  constexpr std::size_t longest = 80;
  if (quantity.size() > longest)
    throw std::invalid_argument(
        fmt::format("{} is too long for a quantity; expected {}", in_quotes(quantity), expected));
  std::string_view rest = trimmed(quantity);
  if (rest.size() > 1 && rest[0] == '+' && rest[1] != '-')
    rest.remove_prefix(1);  // from_chars takes no plus sign
  double number = 0;
  const auto [end, status] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (status == std::errc::result_out_of_range)
    throw std::invalid_argument(
        fmt::format("{} is beyond the range of numbers; expected {}", in_quotes(quantity), expected));
  if (status != std::errc() || !std::isfinite(number))
    throw std::invalid_argument(
        fmt::format("{} does not start with a number; expected {}", in_quotes(quantity), expected));
  rest = trimmed(rest.substr(end - rest.data()));
  if (rest.empty())
    throw std::invalid_argument(fmt::format("{} has no unit; expected {}", in_quotes(quantity), expected));
  return {number, fmt::format("{}{}", rest[0] == '/' ? "1" : "", rest)};
}

/// Whether the unit contains an angle, such as rad/s, degree/s or rpm.
bool has_angle(const ut_unit* unit) {
  char text[256];
  const int length = ut_format(
      unit, text, sizeof text, UT_ASCII | UT_DEFINITION);  // "0.10471975511966 rad.s-1"
  return length > 0 && std::string_view(text, std::min(std::size_t(length), sizeof text)).find("rad") !=
                           std::string_view::npos;
}

/// Refuses a rate of rotation without an angle, and a rate with an angle or in hertz.
void refuse_ambiguous(const Written& written, const ut_unit* unit, const std::string& quantity,
                      const Dimension& dimension) {
  const bool angle = has_angle(unit);
  if (dimension.angle == Dimension::Angle::must && !angle)
    throw std::invalid_argument(fmt::format(
        "{} is a frequency, of which one per second may mean 1 rad/s or one turn, 2 pi rad/s; "
        "expected {} with its unit, such as \"{}\" or \"{:g} rpm\" (turns a minute)",
        in_quotes(quantity), dimension.name, dimension.example, 3000.0));
  if (dimension.angle != Dimension::Angle::foreign_to_rate) return;
  std::string small = written.unit;
  for (char& c : small) c = char(std::tolower(static_cast<unsigned char>(c)));
  if (angle || small.find("hz") != std::string::npos || small.find("hertz") != std::string::npos)
    throw std::invalid_argument(fmt::format(
        "{} counts turns or angles, which may or may not bring a factor of 2 pi; expected {} "
        "with its unit, such as \"{}\"",
        in_quotes(quantity), dimension.name, dimension.example));
}

bool is_letter(char c) { return std::isalpha((unsigned char)c) || c == '_'; }
bool is_digit(char c) { return std::isdigit((unsigned char)c); }

// UDUNITS-2 multiplies by numbers in a unit, so that it would read "1 500 mm" as 0.5 m and "1-2 mm" as -2 mm.
// Allowed are exponents (after letters, "^" or "**", with or without a sign) and the 1 of "1/s".
bool holds_a_number(std::string_view unit) {
  if (unit.starts_with("1/")) unit.remove_prefix(2);
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (!is_digit(unit[i]) || (i > 0 && is_digit(unit[i - 1]))) continue;
    std::size_t before = i;
    while (before > 0 && (unit[before - 1] == '-' || unit[before - 1] == '+')) --before;
    const bool power = before > 0 && (unit[before - 1] == '^' ||
                                      (before > 1 && unit[before - 1] == '*' && unit[before - 2] == '*'));
    const bool exponent = before > 0 && (is_letter(unit[before - 1]) || unit[before - 1] == ')' || power);
    const bool one_over = unit[i] == '1' && i + 1 < unit.size() && unit[i + 1] == '/' && i > 0 &&
                          unit[i - 1] == '(';
    if (!exponent && !one_over) return true;
  }
  return false;
}

/// Ambiguous unit names, and what to write instead.
struct Double {
  const char *word, *what, *instead;
};
constexpr Double doubles[] = {
    {"ton", "the short ton of 907.18 kg here and 1000 kg elsewhere",
     "\"t\" or \"tonne\" for 1000 kg, \"short_ton\" for 907.18 kg"},
    {"tons", "short tons of 907.18 kg here and 1000 kg elsewhere",
     "\"t\" or \"tonne\" for 1000 kg, \"short_ton\" for 907.18 kg"},
    {"ton_force", "the weight of a short ton here and of 1000 kg elsewhere",
     "\"kN\", or \"kip\" for 1000 pounds"},
    {"force_ton", "the weight of a short ton here and of 1000 kg elsewhere",
     "\"kN\", or \"kip\" for 1000 pounds"},
};

/// The ambiguous name that the unit contains, also with a prefix ("kton", "megaton"); null if there is none.
const Double* read_in_two_ways(const std::string& unit) {
  static const std::vector<std::string> prefixes = {"", "k", "M", "m", "G", "kilo", "mega", "milli", "giga"};
  for (std::size_t i = 0, j; i < unit.size(); i = j + 1) {
    for (j = i; j < unit.size() && is_letter(unit[j]); ++j) {
    }
    const std::string word = unit.substr(i, j - i);
    for (const Double& d : doubles)
      for (const std::string& prefix : prefixes)
        if (word == prefix + d.word) return &d;
  }
  return nullptr;
}

}  // namespace

std::string expected_quantity(const Dimension& dimension) {
  return fmt::format("{} with its unit, such as \"{}\"", dimension.name, dimension.example);
}

double to_si(const std::string& quantity, const Dimension& dimension) {
  const std::string expected = expected_quantity(dimension);
  const Written written = split(quantity, expected);
  if (holds_a_number(written.unit))
    throw std::invalid_argument(
        fmt::format("{} holds a second number; expected {}", in_quotes(quantity), expected));
  if (const Double* two = read_in_two_ways(written.unit))
    throw std::invalid_argument(fmt::format("{} can be read in two ways: \"{}\" is {}; expected {}",
                                            in_quotes(quantity), two->word, two->what, two->instead));
  const UnitHandle unit = parse_unit(written.unit), si = parse_unit(dimension.si);
  if (!unit)
    throw std::invalid_argument(fmt::format(
        "unknown unit {} in {}; expected {}", in_quotes(written.unit), in_quotes(quantity), expected));
  const Converter converter(
      ut_are_convertible(unit.get(), si.get()) ? ut_get_converter(unit.get(), si.get()) : nullptr, cv_free);
  // UDUNITS-2 also converts logarithmic scales and those with a shifted origin, which are refused.
  if (!converter || cv_convert_double(converter.get(), 0.0) != 0.0)
    throw std::invalid_argument(
        fmt::format("{} is not {}; expected {}", in_quotes(quantity), dimension.name, expected));
  if (dimension.angle != Dimension::Angle::none) refuse_ambiguous(written, unit.get(), quantity, dimension);
  const double value = cv_convert_double(converter.get(), written.number);
  if (value != 0 && !(std::abs(value) >= 1e-60 && std::abs(value) <= 1e60))
    throw std::invalid_argument(fmt::format(
        "{} is too large or too small to compute with; expected {}", in_quotes(quantity), expected));
  return value;
}

Unit unit_named(const std::string& name, const std::string& si) {
  if (si != "1") return {name, to_si("1 " + name, Dimension{si.c_str(), "a quantity", si.c_str()})};
  if (name == "1") return {name, 1};
  if (name == "%") return {name, 0.01};
  if (name == "1e-6") return {name, 1e-6};
  throw std::invalid_argument("expected \"1\", \"%\" or \"1e-6\"");
}

}  // namespace femsph
