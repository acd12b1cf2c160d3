#include "model/scene/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "model/scene/faults.hpp"

namespace femsph {
namespace {

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;

// Reading the unit database takes milliseconds, so it is done once; it lives as long as the program.
ut_system* unit_system() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    return ut_read_xml(nullptr);
  }();
  if (!system) throw std::invalid_argument("the unit database of UDUNITS-2 could not be read (package libudunits2-data)");
  return system;
}

Unit parse_unit(const std::string& text) { return {ut_parse(unit_system(), text.c_str(), UT_UTF8), ut_free}; }

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
  while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
  return s;
}

struct Written {
  double number;
  std::string unit;
};

// The number is split off by hand: UDUNITS-2 has no zero ("0 N" is not a unit), and reads "1/s" but not "/s".
Written split(const std::string& quantity, const std::string& expected) {
  constexpr std::size_t longest = 80;
  if (quantity.size() > longest)
    throw std::invalid_argument(fmt::format("{} is too long for a quantity; expected {}", in_quotes(quantity), expected));
  std::string_view rest = trimmed(quantity);
  if (rest.size() > 1 && rest[0] == '+' && rest[1] != '-') rest.remove_prefix(1);  // from_chars takes no plus sign
  double number = 0;
  const auto [end, status] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (status == std::errc::result_out_of_range)
    throw std::invalid_argument(fmt::format("{} is beyond the range of numbers; expected {}", in_quotes(quantity), expected));
  if (status != std::errc() || !std::isfinite(number))
    throw std::invalid_argument(fmt::format("{} does not start with a number; expected {}", in_quotes(quantity), expected));
  rest = trimmed(rest.substr(end - rest.data()));
  if (rest.empty()) throw std::invalid_argument(fmt::format("{} has no unit; expected {}", in_quotes(quantity), expected));
  return {number, fmt::format("{}{}", rest[0] == '/' ? "1" : "", rest)};
}

/// The unit has an angle in it, such as rad/s, degree/s or rpm.
bool has_angle(const ut_unit* unit) {
  char text[256];
  const int length = ut_format(unit, text, sizeof text, UT_ASCII | UT_DEFINITION);  // "0.10471975511966 rad.s-1"
  return length > 0 && std::string_view(text, std::min(std::size_t(length), sizeof text)).find("rad") != std::string_view::npos;
}

/// A frequency by name: "Hz", "kHz", "hertz"; or an angle, where none belongs.
void refuse_ambiguous(const Written& written, const ut_unit* unit, const std::string& quantity, const Dimension& dimension) {
  const bool angle = has_angle(unit);
  if (dimension.angle == Dimension::Angle::must && !angle)
    throw std::invalid_argument(fmt::format("{} is a frequency, of which one per second may mean 1 rad/s or one turn, 2 pi rad/s; expected {} with its unit, such as \"{}\" or \"{:g} rpm\" (turns a minute)",
                                            in_quotes(quantity), dimension.name, dimension.example, 3000.0));
  if (dimension.angle != Dimension::Angle::foreign_to_rate) return;
  std::string small = written.unit;
  for (char& c : small) c = char(std::tolower(static_cast<unsigned char>(c)));
  if (angle || small.find("hz") != std::string::npos || small.find("hertz") != std::string::npos)
    throw std::invalid_argument(fmt::format("{} counts turns or angles, which may or may not bring a factor of 2 pi; expected {} with its unit, such as \"{}\"", in_quotes(quantity),
                                            dimension.name, dimension.example));
}

}  // namespace

std::string expected_quantity(const Dimension& dimension) {
  return fmt::format("{} with its unit, such as \"{}\"", dimension.name, dimension.example);
}

double to_si(const std::string& quantity, const Dimension& dimension) {
  const std::string expected = expected_quantity(dimension);
  const Written written = split(quantity, expected);
  const Unit unit = parse_unit(written.unit), si = parse_unit(dimension.si);
  if (!unit)
    throw std::invalid_argument(fmt::format("unknown unit {} in {}; expected {}", in_quotes(written.unit), in_quotes(quantity), expected));
  const Converter converter(ut_are_convertible(unit.get(), si.get()) ? ut_get_converter(unit.get(), si.get()) : nullptr, cv_free);
  // UDUNITS-2 also converts scales with a shifted origin and logarithms; those are not factors.
  if (!converter || cv_convert_double(converter.get(), 0.0) != 0.0)
    throw std::invalid_argument(fmt::format("{} is not {}; expected {}", in_quotes(quantity), dimension.name, expected));
  if (dimension.angle != Dimension::Angle::none) refuse_ambiguous(written, unit.get(), quantity, dimension);
  const double value = cv_convert_double(converter.get(), written.number);
  if (value != 0 && !(std::abs(value) >= 1e-60 && std::abs(value) <= 1e60))
    throw std::invalid_argument(fmt::format("{} is too large or too small to compute with; expected {}", in_quotes(quantity), expected));
  return value;
}

}  // namespace femsph
