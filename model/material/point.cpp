#include "model/material/point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "model/input/faults.hpp"
#include "model/input/lookup.hpp"
#include "model/material/kinematics.hpp"
#include "model/material/laws/point_stress.hpp"

namespace femsph {

namespace {

template <int dim, class LawType>
PointState step(const LawType& law, const std::array<double, 6>& g, double* state) {
  static_assert(point_state_size<LawType, dim> <= 20);
  Symmetric<double, dim> strain;
  if constexpr (dim == 2)
    strain = {g[0], g[1], 0.5 * g[3]};
  else
    strain = {g[0], g[1], g[2], 0.5 * g[3], 0.5 * g[4], 0.5 * g[5]};
  const Symmetric<double, dim> s = advance_law<LawType, double, dim>(law, strain, state);
  const double* history = history_of<LawType, dim>(state);
  PointState out;
  if constexpr (dim == 2) {
    out.stress = {s[0], s[1], law.thickness_stress(strain, s, history), s[2], 0, 0};
    out.strain_across = law.thickness_strain(strain, s, history);
    out.equivalent = plastic::von_mises<double, 2>({s, out.stress[2]});
  } else {
    std::copy_n(s.a, 6, out.stress.begin());
    out.strain_across = strain[2];
    out.equivalent = plastic::von_mises<double, 3>({s, 0.0});
  }
  out.stored_energy = law.stored_energy(strain, s, history);
  if constexpr (!LawType::path_independent) {
    out.plastic_strain = law.plastic_strain(history);
    out.plastic_work = law.plastic_work(history);
  }
  return out;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) {
    const auto first = cell.find_first_not_of(" \t\r"), last = cell.find_last_not_of(" \t\r");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  if (!line.empty() && line.back() == ',') cells.emplace_back();
  return cells;
}

/// Reports only the first fault: a wrong column would be a fault in every line.
[[noreturn]] void refuse(const std::string& file, int line, int column, std::string text) {
  throw InputError(file, {Fault{line, column, std::move(text)}});
}

std::vector<int> columns_of(const std::vector<std::string>& header, const std::string& file, Plane plane) {
  std::vector<std::string> known;
  for (int c : path_components(plane)) known.emplace_back(path_names[std::size_t(c)]);
  std::vector<int> columns;
  for (std::size_t k = 0; k < header.size(); ++k) {
    const auto found = std::find(known.begin(), known.end(), header[k]);
    if (found == known.end())
      refuse(file, 1, int(k) + 1,
             fmt::format("column {} of the path is {}{}", k + 1, in_quotes(header[k]),
                         expected_names(header[k], known)));
    const int column = path_components(plane)[std::size_t(found - known.begin())];
    if (std::count(columns.begin(), columns.end(), column))
      refuse(file, 1, int(k) + 1, fmt::format("column {} is given twice", in_quotes(header[k])));
    columns.push_back(column);
  }
  return columns;
}

}  // namespace

MaterialPoint::MaterialPoint(const Law& law) : law_(law) {
  std::visit(
      [](auto& l) {
        if constexpr (requires { l.return_cauchy(); }) l.return_cauchy();
      },
      law_);
}

PointState MaterialPoint::advance(const std::array<double, 6>& strain) {
  return std::visit(
      [&](const auto& law) {
        return law.elastic().plane == Plane::none ? step<3>(law, strain, state_.data())
                                                  : step<2>(law, strain, state_.data());
      },
      law_);
}

std::vector<int> path_components(Plane plane) {
  return plane == Plane::none ? std::vector<int>{0, 1, 2, 3, 4, 5} : std::vector<int>{0, 1, 3};
}

std::vector<std::array<double, 6>> read_path(const std::string& text, const std::string& file, Plane plane) {
  std::vector<std::array<double, 6>> path;
  std::vector<int> columns;
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    refuse(file, 1, 1, "is UTF-16; expected plain text or UTF-8, as \"CSV UTF-8\" is saved");
  std::stringstream in(text.starts_with("\xef\xbb\xbf")
                           ? text.substr(3)
                           : text);  // without the byte-order mark that spreadsheets write
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::vector<std::string> cells = cells_of(line);
    if (number == 1) {
      columns = columns_of(cells, file, plane);
      continue;
    }
    if (cells.empty() || (cells.size() == 1 && cells[0].empty())) continue;
    if (cells.size() != columns.size())
      refuse(file, number, 1,
             fmt::format("{} values; expected {}, as in the header", cells.size(), columns.size()));
    std::array<double, 6> strain{};
    for (std::size_t k = 0; k < cells.size(); ++k) {
      double value = 0;
      const char *begin = cells[k].data(), *end = begin + cells[k].size();
      if (end - begin > 1 && begin[0] == '+' && begin[1] != '-') ++begin;  // from_chars takes no plus sign
      const auto [stop, error] = std::from_chars(begin, end, value);
      if (error != std::errc() || stop != end || !std::isfinite(value))
        refuse(file, number, int(k) + 1,
               fmt::format(
                   "value {} is {}; expected a number (a strain, such as 1e-3)", k + 1, in_quotes(cells[k])));
      strain[std::size_t(columns[k])] = value;
    }
    path.push_back(strain);
  }
  if (path.empty())
    refuse(file, 1, 1, "no strain in the path; expected a header such as exx,eyy,gxy and one row a step");
  return path;
}

std::string point_csv(const Law& law, Plane plane, const std::vector<std::array<double, 6>>& path) {
  constexpr std::array<const char*, 6> stress_names{"sxx", "syy", "szz", "sxy", "syz", "szx"};
  std::vector<std::size_t> strains, stresses;
  for (int c : path_components(plane)) strains.push_back(std::size_t(c));
  for (std::size_t c = 0; c < (plane == Plane::none ? 6 : 4); ++c) stresses.push_back(c);
  std::string text;
  for (std::size_t c : strains) text += fmt::format("{},", path_names[c]);
  if (plane == Plane::stress) text += "ezz,";
  for (std::size_t c : stresses) text += fmt::format("{} [Pa],", stress_names[c]);
  text += "equivalent_stress [Pa],plastic_strain,plastic_work [J/m^3],stored_energy [J/m^3]\n";
  MaterialPoint point(law);
  for (const auto& strain : path) {
    const PointState now = point.advance(strain);
    for (std::size_t c : strains) text += fmt::format("{:.17g},", strain[c]);
    if (plane == Plane::stress) text += fmt::format("{:.17g},", now.strain_across);
    for (std::size_t c : stresses) text += fmt::format("{:.17g},", now.stress[c]);
    text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g}\n", now.equivalent, now.plastic_strain,
                        now.plastic_work, now.stored_energy);
  }
  return text;
}

}  // namespace femsph
