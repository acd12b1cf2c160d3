// [[runs]] and [limit] of a study: what to run, and how fine.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "compare/overrides.hpp"
#include "compare/study_reading.hpp"
#include "model/scene/units.hpp"

namespace femsph::compare {
namespace {

const std::string divisions_expected = "a list of cells along the axes, such as [\"20x2\", \"40x4\"]";

std::vector<Method> read_methods(Fields& fields) {
  std::vector<Method> found;
  const auto names = fields.texts("methods", Need::required, "a list of methods, such as [\"fem-full\"]");
  if (names && names->empty()) fields.fault("methods", "\"methods\" is empty; expected a list of methods, such as [\"fem-full\"]");
  for (const std::string& name : names.value_or(std::vector<std::string>{})) {
    try {
      found.push_back(method_named(name));
    } catch (const std::runtime_error& e) {
      fields.fault("methods", e.what());
    }
  }
  return found;
}

std::vector<Resolution> read_resolutions(Fields& fields, int dim) {
  std::vector<Resolution> all;
  const auto spacings = fields.quantities("spacing", Need::optional, dimension::length, Sign::positive);
  const auto divisions = fields.texts("divisions", Need::optional, divisions_expected);
  if (fields.has("spacing") == fields.has("divisions")) {
    fields.fault("spacing", "expected either \"spacing\", such as [\"20 mm\", \"10 mm\"], or \"divisions\", such as [\"20x2\", \"40x4\"]");
    return all;
  }
  for (const double spacing : spacings.value_or(std::vector<double>{})) all.push_back({spacing, {}});
  for (const std::string& text : divisions.value_or(std::vector<std::string>{})) {
    const auto cells = parse_divisions(text);
    if (cells && ((*cells)[2] > 0) == (dim == 3))
      all.push_back({0, *cells});
    else
      fields.fault("divisions", fmt::format("{} in \"divisions\"; expected {} whole numbers with \"x\" between", in_quotes(text), dim));
  }
  return all;
}

std::string default_case(const Resolution& resolution) {
  const auto& n = resolution.divisions;
  if (resolution.spacing > 0) return fmt::format("d={:g}mm", 1e3 * resolution.spacing);
  return n[2] > 0 ? fmt::format("{}x{}x{}", n[0], n[1], n[2]) : fmt::format("{}x{}", n[0], n[1]);
}

std::vector<std::string> read_cases(Fields& fields, const std::vector<Resolution>& resolutions) {
  std::vector<std::string> defaults;
  for (const Resolution& resolution : resolutions) defaults.push_back(default_case(resolution));
  const auto cases = fields.texts("cases", Need::optional, "a list of names, one for each spacing or division");
  if (!cases) return defaults;
  if (cases->size() == resolutions.size()) return *cases;
  fields.fault("cases", fmt::format("{} cases for {} resolutions; expected as many", cases->size(), resolutions.size()));
  return defaults;
}

void one_block(Fields& fields, StudyReading& reading, int ladder) {
  const std::string file = fields.text("scene", Need::optional, "the file of a scene").value_or(reading.default_scene);
  const Scene* scene = scene_of(fields, "scene", file, reading);
  std::vector<Method> chosen = read_methods(fields);
  const auto resolutions = read_resolutions(fields, scene ? scene->dim() : 2);
  const auto cases = read_cases(fields, resolutions);
  const auto quick = read_names(fields, "quick", cases, "case");
  const auto step = fields.quantity("step", Need::optional, dimension::time, Sign::positive);
  const auto label = fields.text("label", Need::optional, "a name for the method in tables");
  const auto safety = fields.number("safety", Need::optional, "a number above 0: the step over the critical step");
  if (safety && *safety <= 0)
    fields.fault("safety", "\"safety\" is not positive; expected a number above 0: the step over the critical step");
  if (label && chosen.size() > 1) fields.fault("label", "\"label\" with several methods; expected it with one");
  Overrides overrides;
  if (auto options = fields.table("options", Need::optional, "a table such as {smoothing = 1.2}"))
    overrides = read_overrides(*options, chosen);
  fields.done();
  for (std::size_t i = 0; i < resolutions.size(); ++i)
    for (const Method& method : chosen) {
      PlannedRun run{cases[i], label.value_or(method.name + overrides.describe()), method, resolutions[i], file, {}, false, ladder};
      overrides.apply(run.method);
      if (safety) run.march.safety = *safety;
      run.march.step = step;
      run.quick = std::find(quick.begin(), quick.end(), cases[i]) != quick.end();
      reading.study.runs.push_back(run);
    }
}

}  // namespace

bool QuantitySpec::is_of(const PlannedRun& run) const {
  return (!scene || *scene == run.scene) && (methods.empty() || std::find(methods.begin(), methods.end(), run.label) != methods.end());
}

std::optional<std::array<int, 3>> parse_divisions(const std::string& text) {
  std::array<int, 3> cells{};
  const char *at = text.data(), *end = at + text.size();
  for (int axis = 0; axis < 3; ++axis) {
    const auto [next, error] = std::from_chars(at, end, cells[axis]);
    if (error != std::errc() || cells[axis] < 1 || cells[axis] > 1'000'000) return {};
    if (next == end) return axis >= 1 ? std::optional(cells) : std::nullopt;
    if (*next != 'x') return {};
    at = next + 1;
  }
  return {};
}

void read_runs(Fields& root, StudyReading& reading) {
  int ladder = 0;
  for (Fields& fields : root.tables("runs")) one_block(fields, reading, ladder++);
}

void read_limit(Fields& root, StudyReading& reading) {
  auto fields = root.table("limit", Need::optional, "a table with divisions = \"100x10\" and degree = 4");
  if (!fields) return;
  LimitSpec limit;
  const auto text = fields->text("divisions", Need::required, "cells along the axes, such as \"100x10\"");
  limit.degree = fields->count("degree", Need::optional, 1, 8).value_or(limit.degree);
  fields->done();
  if (!text) return;
  if (const auto cells = parse_divisions(*text))
    limit.divisions = *cells;
  else
    fields->fault("divisions", fmt::format("\"divisions\" is {}; expected cells along the axes, such as \"100x10\"", in_quotes(*text)));
  reading.study.limit = limit;
}

}  // namespace femsph::compare
