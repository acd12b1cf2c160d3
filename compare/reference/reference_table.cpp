#include "compare/reference/reference_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "model/input/faults.hpp"
#include "model/input/units.hpp"

namespace femsph::compare {
namespace {

/// The unit in "NAME [unit]", as a factor to SI.
double factor_of(const std::string& head, const std::string& si, const std::string& file) {
  const auto open = head.rfind('['), close = head.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open)
    throw std::runtime_error(fmt::format(
        "{}:1: the column {} has no unit; expected it in brackets, such as \"tip [{}]\"", file,
        in_quotes(head), si));
  try {
    return unit_named(head.substr(open + 1, close - open - 1), si).factor;
  } catch (const std::invalid_argument&) {
    throw std::runtime_error(fmt::format(
        "{}:1: the column {} has another unit; expected one of the same kind as {}", file, in_quotes(head),
        in_quotes(si)));
  }
}

}  // namespace

ReferenceTable read_reference_table(const std::string& file, const std::string& si) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(fmt::format("no such file {}", in_quotes(file)));
  std::string line;
  std::getline(in, line);
  const auto comma = line.find(',');
  if (comma == std::string::npos)
    throw std::runtime_error(fmt::format("{}:1: expected two columns, \"time [s],NAME [{}]\"", file, si));
  const double time = factor_of(line.substr(0, comma), "s", file),
               unit = factor_of(line.substr(comma + 1), si, file);
  ReferenceTable table;
  for (int number = 2; std::getline(in, line); ++number) {
    const char* text = line.c_str();
    char *middle = nullptr, *end = nullptr;
    const double at = std::strtod(text, &middle);
    const double value = *middle == ',' ? std::strtod(middle + 1, &end) : NAN;
    if (middle == text || !end || end == middle + 1 || (*end && *end != '\r') || !std::isfinite(at) ||
        !std::isfinite(value))
      throw std::runtime_error(
          fmt::format("{}:{}: {} is not a row of two numbers", file, number, in_quotes(line)));
    if (!table.at.empty() && !(at * time > table.at.back()))
      throw std::runtime_error(fmt::format("{}:{}: the times do not increase", file, number));
    table.at.push_back(at * time), table.value.push_back(value * unit);
  }
  if (table.at.size() < 2) throw std::runtime_error(fmt::format("{}: expected at least two rows", file));
  return table;
}

}  // namespace femsph::compare
