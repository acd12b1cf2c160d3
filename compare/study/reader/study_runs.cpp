// [[runs]] of a study: the runs with their methods and resolutions.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "compare/run/plan/method_option.hpp"
#include "compare/study/reader/study_page.hpp"
#include "compare/study/reader/study_reading.hpp"
#include "model/input/units.hpp"

namespace femsph::compare {

KeyTable run_keys() {
  return {
      "[[runs]]",
      "Runs every method at every resolution. The runs of one table form one ladder, whose order of "
      "convergence is in orders.csv.",
      {{"methods", key_holds::texts,
        "Names of methods: see `femsph list`. A method for each body is one text: "
        "[\"bar=sph-corrected,plate=fem-full\"], or \"fem-full,bar=sph-corrected\" with the method of all "
        "other bodies.",
        true},
       {"spacing", key_holds::quantities(dimension::length),
        "Particle spacings, or edge lengths of cells. Either this or \"divisions\"."},
       {"divisions", key_holds::texts, "Cells along the axes, such as [\"20x2\", \"40x4\"]."},
       {"cases", key_holds::texts, "A name for each resolution. \"20x2\" or \"d=20mm\" unless given."},
       {"quick", key_holds::texts, "Which of these cases --quick runs. None unless given."},
       {"scene", "a text: the file of a scene, beside the study", "The study's scene unless given."},
       {"smoothing_lengths", key_holds::numbers,
        "SPH with each of these smoothing lengths, h over the spacing; each counts as a method. With a "
        "method for each body: for those with SPH."},
       {"safety", key_holds::number,
        "The time step over the critical step, up to 2 (above 1 only to show the instability). 0.9 unless "
        "given."},
       {"step", key_holds::quantity(dimension::time), "A fixed time step, instead of \"safety\"."},
       {"label", key_holds::text,
        "A name for the method in tables; only with one method. Its name and options unless given."}}};
}

std::vector<BodyMethods> read_methods(Fields& fields, Need need, const Scene* scene) {
  std::vector<BodyMethods> found;
  const auto names = fields.texts("methods", need, "a list of methods, such as [\"fem-full\"]");
  if (names && names->empty())
    fields.fault("methods", "\"methods\" is empty; expected a list of methods, such as [\"fem-full\"]");
  for (const std::string& name : names.value_or(std::vector<std::string>{})) {
    try {
      found.push_back(read_body_methods(name, scene));
    } catch (const std::runtime_error& e) {
      fields.fault("methods", e.what());
    }
  }
  return found;
}

namespace {

const std::string divisions_expected = "a list of cells along the axes, such as [\"20x2\", \"40x4\"]";

std::vector<Resolution> read_resolutions(Fields& fields, int dim) {
  std::vector<Resolution> all;
  const auto spacings = fields.quantities("spacing", Need::optional, dimension::length, Sign::positive);
  const auto divisions = fields.texts("divisions", Need::optional, divisions_expected);
  if (fields.has("spacing") == fields.has("divisions")) {
    if (!fields.misspelt({"spacing", "divisions"}))
      fields.fault("spacing",
                   "expected either \"spacing\", such as [\"20 mm\", \"10 mm\"], or \"divisions\", such as "
                   "[\"20x2\", \"40x4\"]");
    return all;
  }
  for (const double spacing : spacings.value_or(std::vector<double>{})) all.push_back({spacing, {}});
  for (const std::string& text : divisions.value_or(std::vector<std::string>{})) {
    const auto cells = parse_divisions(text);
    if (cells && (dim == 0 || ((*cells)[2] > 0) == (dim == 3)))
      all.push_back({0, *cells});
    else
      fields.fault(
          "divisions",
          fmt::format("{} in \"divisions\"; expected {} whole numbers with \"x\" between", in_quotes(text),
                      dim == 0   ? "2 or 3"
                      : dim == 2 ? "2"
                                 : "3"));
  }
  return all;
}

std::string default_case(const Resolution& resolution) {
  const auto& n = resolution.divisions;
  if (resolution.spacing > 0) return fmt::format("d={:g}mm", 1e3 * resolution.spacing);
  return n[2] > 0 ? fmt::format("{}x{}x{}", n[0], n[1], n[2]) : fmt::format("{}x{}", n[0], n[1]);
}

/// `complete`: there was no fault in the resolutions, so that their number is known.
std::vector<std::string> read_cases(Fields& fields, const std::vector<Resolution>& resolutions,
                                    bool complete) {
  std::vector<std::string> defaults;
  for (const Resolution& resolution : resolutions) defaults.push_back(default_case(resolution));
  const auto cases = fields.texts(
      "cases", Need::optional, "a list of names, one for each spacing or division");
  if (!cases) return defaults;
  if (cases->size() == resolutions.size()) return *cases;
  if (!complete) return defaults;
  fields.fault("cases", fmt::format("{} cases for {} resolutions; expected as many", cases->size(),
                                    resolutions.size()));
  return defaults;
}

/// Smoothing lengths over the spacing, each of which counts as a method. Not given: the methods as they are.
std::vector<std::optional<double>> read_smoothing_lengths(
    Fields& fields, const std::vector<BodyMethods>& chosen, const Overrides& overrides) {
  const char* const key = "smoothing_lengths";
  if (fields.has("supports")) {
    fields.accept("supports");  // no second message that the key is unknown
    fields.fault("supports", "\"supports\" is the old name of \"smoothing_lengths\"; expected the new name");
    return {std::nullopt};
  }
  const auto given = fields.numbers(key, Need::optional);
  const OptionRange& range = *method_option("smoothing").range;
  if (!given) return {std::nullopt};
  if (given->empty() || std::any_of(given->begin(), given->end(), [&](double h) { return !range.holds(h); }))
    fields.fault(key, fmt::format("\"smoothing_lengths\" holds a value that is not {}; expected smoothing "
                                  "lengths over the spacing, such as [1.0, 1.2, 1.4]",
                                  range.describe()));
  if (overrides.has("smoothing") || fields.has("label"))
    fields.fault(key, "\"smoothing_lengths\" beside a smoothing or a label; expected one of them");
  for (const BodyMethods& method : chosen)
    if (method.all_fem())
      fields.fault(key, fmt::format("\"smoothing_lengths\" with {}; expected it with SPH only", method.name));
  return {given->begin(), given->end()};
}

/// The methods' name in tables, with their changes beside the method of each body.
std::string label_of(const BodyMethods& methods, const Overrides& overrides,
                     const std::optional<double>& smoothing) {
  std::string label;
  for (const BodyMethod& entry : methods.entries) {
    label += (label.empty() ? "" : ",") + entry.body + (entry.body.empty() ? "" : "=");
    label += entry.method.name + overrides.describe(entry.method);
    if (smoothing && !entry.method.is_fem()) label += fmt::format(" h={:g}d", *smoothing);
  }
  return label;
}

/// FEM of bodies whose shapes are made of cells (mesh files) has one resolution, whatever the spacing:
/// several would repeat the same run.
void refuse_same_cells(Fields& fields, const Scene* scene, const std::vector<BodyMethods>& chosen,
                       std::size_t resolutions) {
  if (!scene || resolutions < 2) return;
  for (const BodyMethods& method : chosen)
    if (std::all_of(scene->bodies.begin(), scene->bodies.end(), [&](const Body& b) {
          return b.rigid || (b.shape && b.shape->cells() && method.of(b).is_fem());
        }))
      fields.fault(
          fields.has("spacing") ? "spacing" : "divisions",
          fmt::format("{} resolutions for {}, but the cells of every body come from its shape; expected one",
                      resolutions, method.name));
}

void one_block(Fields& fields, StudyReading& reading, int ladder) {
  const std::string file =
      fields.text("scene", Need::optional, "the file of a scene").value_or(reading.default_scene);
  const Scene* scene = fields.misspelt({"scene"}) ? nullptr : scene_of(fields, "scene", file, reading);
  std::size_t faults = reading.faults.size();
  const std::vector<BodyMethods> chosen = read_methods(fields, Need::required, scene);
  const std::size_t before = reading.faults.size();
  const auto resolutions = read_resolutions(fields, scene ? scene->dim() : 0);
  const bool misspelt = fields.misspelt(
      {"scene", "methods", "spacing", "divisions", "cases", "label", "options", "smoothing_lengths"});
  const auto cases = read_cases(fields, resolutions, !misspelt && reading.faults.size() == before);
  const auto label = fields.text("label", Need::optional, "a name for the method in tables");
  if (misspelt || reading.faults.size() > faults) reading.runs_known = false;
  const auto quick = read_names(fields, "quick", cases, "case", reading.runs_known);
  const auto step = fields.quantity("step", Need::optional, dimension::time, Sign::positive);
  const std::string safety_expected =
      "a number above 0, up to 2: the step over the critical step";  // above 1: to show the instability
  const auto safety = fields.number("safety", Need::optional, safety_expected);
  if (safety && !(*safety > 0 && *safety <= 2))
    fields.fault("safety", fmt::format("\"safety\" is {:g}; expected {}", *safety, safety_expected));
  if (safety && step) fields.fault("safety", "\"safety\" beside \"step\"; expected one of them");
  refuse_same_cells(fields, scene, chosen, resolutions.size());
  if (label && chosen.size() > 1)
    fields.fault("label", "\"label\" with several methods; expected it with one");
  faults = reading.faults.size();
  Overrides overrides;
  if (auto options = fields.table("options", Need::optional, "a table such as {smoothing = 1.2}"))
    overrides = read_overrides(*options, chosen);
  const auto smoothing_lengths = read_smoothing_lengths(fields, chosen, overrides);
  if (reading.faults.size() > faults) reading.runs_known = false;
  fields.done();
  for (std::size_t i = 0; i < resolutions.size(); ++i)
    for (const BodyMethods& methods : chosen)
      for (const auto& smoothing : smoothing_lengths) {
        Overrides changes = overrides;
        if (smoothing) changes.set("smoothing", *smoothing);
        const std::string name = label.value_or(label_of(methods, overrides, smoothing));
        PlannedRun run{cases[i], name, methods, resolutions[i], file, {}, false, ladder};
        changes.apply(run.methods);
        if (safety) run.march.safety = *safety;
        run.march.step = step;
        run.quick = std::find(quick.begin(), quick.end(), cases[i]) != quick.end();
        reading.study.runs.push_back(run);
      }
}

}  // namespace

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
  if (root.misspelt({"runs", "studies"})) reading.runs_known = false;
  for (Fields& fields : root.tables("runs")) one_block(fields, reading, ladder++);
}

void read_repeat(Fields& root, StudyReading& reading) {
  reading.study.repeat = root.count("repeat", Need::optional, 1, 99).value_or(1);
}

}  // namespace femsph::compare
