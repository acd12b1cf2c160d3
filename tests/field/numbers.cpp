// Takes a number from what a run has left, and compares it with the right value.

#include "numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "compare/measure/errors.hpp"
#include "model/input/units.hpp"

namespace femsph::field {

std::string file_text(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("the run left no " + std::filesystem::path(file).filename().string());
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

namespace {

struct Column {
  std::string unit;
  std::vector<double> values;
};

/// A table that the program wrote: "name [unit]" above, then numbers.
std::map<std::string, Column> read_csv(const std::string& file) {
  std::istringstream in(file_text(file));
  std::map<std::string, Column> table;
  std::vector<Column*> order;
  std::string line, cell;
  std::getline(in, line);
  for (std::istringstream head(line); std::getline(head, cell, ',');) {
    const auto open = cell.rfind(" [");
    Column& column = table[cell.substr(0, open)];
    column.unit = cell.substr(open + 2, cell.size() - open - 3);
    order.push_back(&column);
  }
  while (std::getline(in, line)) {
    std::size_t c = 0;
    for (std::istringstream row(line); c < order.size() && std::getline(row, cell, ',');)
      order[c++]->values.push_back(std::strtod(cell.c_str(), nullptr));
  }
  return table;
}

/// In SI; UDUNITS-2 is not thread-safe.
double si(const Quantity& quantity, const std::string& unit) {
  static std::mutex mutex;
  if (quantity.unit == "1") return quantity.number;
  const std::lock_guard lock(mutex);
  return quantity.number * to_si("1 " + quantity.unit, Dimension{unit.c_str(), "a quantity", unit.c_str()});
}

double integral(const std::vector<double>& at, const std::vector<double>& v) {
  double sum = 0;
  for (std::size_t i = 1; i < at.size(); ++i) sum += (at[i] - at[i - 1]) * (v[i] + v[i - 1]) / 2;
  return sum;
}

/// One number of a history; `stop`: when it last was more than 1e-3 of its range away from where it ends.
double reduced(Reduce reduce, const std::vector<double>& at, const std::vector<double>& v) {
  const auto [low, high] = std::minmax_element(v.begin(), v.end());
  switch (reduce) {
    case Reduce::final:
      return v.back();
    case Reduce::first:
      return v.front();
    case Reduce::max:
      return *high;
    case Reduce::min:
      return *low;
    case Reduce::peak:
      return std::abs(*low) > std::abs(*high) ? *low : *high;
    case Reduce::mean:
      return integral(at, v) / (at.back() - at.front());
    case Reduce::middle:
      return (*low + *high) / 2;
    case Reduce::swing:
      return (*high - *low) / 2;
    case Reduce::integral:
      return integral(at, v);
    case Reduce::frequency:
      if (const auto f = compare::dominant_frequency(at, v)) return *f;
      throw std::runtime_error("the history does not swing back, so it has no frequency");
    case Reduce::stop:
      for (std::size_t i = v.size(); i-- > 0;)
        if (std::abs(v[i] - v.back()) > 1e-3 * (*high - *low)) return at[i];
      return at.front();
  }
  return NAN;
}

std::pair<double, std::string> number_of(const Read& read, const std::string& folder,
                                         const std::string& printed) {
  if (!read.after.empty()) {
    const auto at = printed.find(read.after);
    if (at == std::string::npos) throw std::runtime_error(fmt::format("\"{}\" is not printed", read.after));
    const auto digit = printed.find_first_of("0123456789-", at + read.after.size());
    if (digit == std::string::npos)
      throw std::runtime_error(fmt::format("no number is printed behind \"{}\"", read.after));
    return {std::strtod(printed.c_str() + digit, nullptr), "1"};
  }
  const auto table = read_csv(folder + "/" + read.table + ".csv");
  const std::vector<double>& place = table.at(read.table == "history" ? "time" : "distance").values;
  std::vector<double> at, v;
  std::string unit;
  for (std::size_t i = 0; i < place.size(); ++i)
    if (!read.window || (place[i] >= (*read.window)[0] && place[i] <= (*read.window)[1]))
      at.push_back(place[i]), v.push_back(0);
  for (const std::string& term : read.columns) {
    const double sign = term.starts_with("-") ? -1 : 1;
    const std::string name = term.substr(sign < 0);
    const auto found = table.find(name);
    if (found == table.end())
      throw std::runtime_error(fmt::format("{}.csv has no column {}", read.table, name));
    unit = found->second.unit;
    for (std::size_t i = 0, k = 0; i < place.size(); ++i)
      if (!read.window || (place[i] >= (*read.window)[0] && place[i] <= (*read.window)[1]))
        v[k++] += sign * found->second.values.at(i);
  }
  if (v.empty()) throw std::runtime_error("no sample lies in the window");
  if (read.reduce == Reduce::integral) unit += " s";
  if (read.reduce == Reduce::frequency) unit = "Hz";
  if (read.reduce == Reduce::stop) unit = "s";
  return {reduced(read.reduce, at, v), unit};
}

}  // namespace

std::string shown(double number, const std::string& unit) {
  return fmt::format("{:.5g}{}", number, unit == "1" ? "" : " " + unit);
}

void compare_read(const Read& read, const std::string& folder, const std::string& printed, Finding& finding) {
  const auto [number, unit] = number_of(read, folder, printed);
  const Quantity& main = read.value ? *read.value : read.least ? *read.least : *read.most;
  const double found = number / si({1, main.unit}, unit);
  bool good = std::isfinite(found);
  finding.found = shown(found, main.unit);
  if (read.value) {
    const double right = read.value->number;
    const double band = read.percent ? std::abs(right) * *read.percent / 100
                                     : si(*read.within, unit) / si({1, main.unit}, unit);
    good = good && std::abs(found - right) <= band;
    finding.right = fmt::format(
        "{} +- {}", shown(right, main.unit),
        read.percent ? fmt::format("{:g} %", *read.percent) : shown(read.within->number, read.within->unit));
    if (right != 0) finding.found += fmt::format(" ({:+.2g} %)", 100 * (found / right - 1));
  }
  if (read.least)
    good = good && number >= si(*read.least, unit),
    finding.right += (finding.right.empty() ? "" : ", ") +
                     ("at least " + shown(read.least->number, read.least->unit));
  if (read.most)
    good = good && number <= si(*read.most, unit),
    finding.right += (finding.right.empty() ? "" : ", ") +
                     ("at most " + shown(read.most->number, read.most->unit));
  finding.verdict = good ? Verdict::pass : Verdict::fail;
}

namespace {
const char* const names[] = {
    "final", "first", "max", "min", "peak", "mean", "middle", "swing", "integral", "frequency", "stop"};

}  // namespace

std::string name_of(const Read& read) {
  if (!read.after.empty()) return "\"" + read.after + "\"";
  return fmt::format("{} {}{}", names[int(read.reduce)], read.table == "history" ? "" : read.table + ": ",
                     fmt::join(read.columns, " + "));
}

}  // namespace femsph::field
