#include "model/results/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/results/hdf5.hpp"
#include "model/results/whole_file.hpp"

namespace femsph {

namespace {

auto find(const std::vector<Column>& columns, const std::string& name) {
  return std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
}

void require_equal_lengths(const std::vector<Column>& columns, const std::string& file) {
  for (const Column& c : columns)
    if (c.values.size() != columns[0].values.size())
      throw std::logic_error(fmt::format("{}: column {} has {} rows, column {} has {}", file, columns[0].name,
                                         columns[0].values.size(), c.name, c.values.size()));
}

/// RFC 4180: a field that contains a separator is quoted, and quotes in it are doubled.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

void write_csv(const std::vector<Column>& columns, const std::string& file) {
  require_equal_lengths(columns, file);
  fmt::memory_buffer out;
  const auto line = [&](const auto& field) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) out.push_back(',');
      field(columns[c]);
    }
    out.push_back('\n');
  };
  line([&](const Column& c) {
    fmt::format_to(fmt::appender(out), "{}", csv_field(fmt::format("{} [{}]", c.name, c.unit)));
  });
  const std::size_t rows = columns.empty() ? 0 : columns[0].values.size();
  for (std::size_t row = 0; row < rows; ++row)
    line([&](const Column& c) {
      const double x = c.values[row];
      fmt::format_to(fmt::appender(out), "{:.17g}",
                     std::isnan(x) ? std::abs(x) : x);  // not every reader accepts "-nan"
    });
  write_whole({out.data(), out.size()}, file);
}

}  // namespace

std::size_t History::add(std::string name, std::string unit) {
  if (has(name)) throw std::logic_error("a history has two columns \"" + name + "\"");
  columns.push_back({std::move(name), std::move(unit), {}});
  return columns.size() - 1;
}

const Column& History::operator[](const std::string& name) const {
  const auto found = find(columns, name);
  if (found != columns.end()) return *found;
  std::string names;
  for (const Column& c : columns) names += (names.empty() ? "" : ", ") + c.name;
  throw std::out_of_range(
      fmt::format("no column \"{}\" in this history; it has: {}", name, names.empty() ? "none" : names));
}

bool History::has(const std::string& name) const { return find(columns, name) != columns.end(); }

void write_csv(const History& history, const std::string& file) { write_csv(history.columns, file); }

void write_csv(const Profile& profile, const std::string& file) {
  std::vector<Column> columns{{"distance", "m", profile.distance}};
  columns.insert(columns.end(), profile.columns.begin(), profile.columns.end());
  columns.push_back({"time", "s", std::vector<double>(profile.distance.size(), profile.time)});
  write_csv(columns, file);
}

void write_hdf5(const History& history, const std::string& file) {
  require_equal_lengths(history.columns, file);
  hdf5::Image image(file);
  for (const Column& c : history.columns) {
    image.dataset(c.name, c.values, {c.values.size()});
    image.attribute(c.name, "unit", c.unit);
  }
  write_whole(image.bytes(), file);
}

void write_text(const std::string& text, const std::string& file) { write_whole(text, file); }

}  // namespace femsph
