// [[series]] of a study: the data files of its figures.

#include <fmt/format.h>

#include "compare/study/reader/study_observed.hpp"
#include "compare/study/reader/study_page.hpp"
#include "compare/study/reader/study_reading.hpp"

namespace femsph::compare {
namespace {

const std::vector<std::pair<std::string, SeriesSpec::Kind>> series_kinds = {
    {"error", SeriesSpec::Kind::error},
    {"cases", SeriesSpec::Kind::cases},
    {"history", SeriesSpec::Kind::history},
    {"profile", SeriesSpec::Kind::profile},
    {"path", SeriesSpec::Kind::path}};
const std::vector<std::pair<std::string, Reference>> series_references = {
    {"theory", Reference::theory}, {"limit", Reference::limit}, {"value", Reference::value}};

std::string read_file_name(Fields& fields) {
  const std::string expected = "a file name of letters, digits, ., _ and -, ending in .csv";
  const auto file = fields.text("file", Need::required, expected);
  if (!file) return "";
  if (!is_file_name(*file, ".") || !file->ends_with(".csv") || file->starts_with("."))
    fields.fault("file", fmt::format("\"file\" is {}; expected {}", in_quotes(*file), expected));
  return *file;
}

void one_series(Fields& fields, StudyReading& reading) {
  using Kind = SeriesSpec::Kind;
  const Study& study = reading.study;
  SeriesSpec series;
  series.file = read_file_name(fields);
  const auto kind = fields.choice("kind", Need::required, series_kinds);
  if (!kind) return fields.accept_rest(), fields.done();
  series.kind = *kind;
  series.cases = read_names(fields, "cases", case_names(study), "case", reading.runs_known);
  series.methods = read_names(fields, "methods", method_labels(study), "method", reading.runs_known);
  if (series.kind == Kind::error || series.kind == Kind::cases) {
    const auto known = quantity_names(study);
    const auto quantity = fields.text("quantity", Need::required, one_of(known));
    series.quantity = quantity.value_or("");
    series.reference =
        fields.choice("reference", Need::optional, series_references).value_or(Reference::theory);
    if (quantity)
      require_known(fields, "quantity", "quantity", series.quantity, known, reading.quantities_known);
  } else {
    series.scene = read_scene_name(fields, Need::optional, reading);
    series.observed = read_observed(fields, series.scene, "", study);
    if (series.kind == Kind::path) {
      auto along = fields.table(
          "along", Need::required, "a table such as {probe = \"strain\", component = \"xx\"}");
      if (along) series.along = read_observed(*along, series.scene, "", study), along->done();
    }
    series.theory = read_theory(
        fields, series.scene, series.observed.si, series.kind == Kind::history, study);
    if (series.kind == Kind::history)
      series.time_unit = read_unit(
          fields, "time_unit", fields.text("time_unit", Need::optional).value_or("ms"), "s");
    if (series.observed.section.empty() == (series.kind == Kind::profile) &&
        !fields.misspelt({"probe", "section", "energy", "scalar", "column"}))
      fields.fault("kind",
                   "\"kind\" does not fit; expected \"profile\" with a section, \"history\" with a probe or "
                   "an energy");
  }
  fields.done();
  reading.study.series.push_back(series);
}

}  // namespace

KeyTable series_keys() {
  return {
      "[[series]]", "A file under data/ for figures.",
      joined({{"file", key_holds::text, "The name of the file, ending in .csv.", true},
              {"kind", key_holds::words(series_kinds),
               "The error of a quantity over the spacing, or over the cases; a history; the profile of a "
               "section; or a path: one history over another.",
               true},
              {"cases", key_holds::texts, "Only of these cases."},
              {"methods", key_holds::texts, "Only of these labels (names of methods in tables)."},
              {"quantity", "a text: a quantity of this study", "The quantity whose error is written.", false,
               "with kind \"error\" or \"cases\""},
              {"reference", key_holds::words(series_references),
               "What the errors are measured against. \"theory\" unless given."},
              scene_key("The scene whose theory is written. That of the first run unless given."),
              theory_key(),
              {"time_unit", "a text: a unit of time", "The unit of time of a history. \"ms\" unless given."}},
             observed_keys())};
}

KeyTable series_along_keys() {
  return {"[series.along]", "With kind \"path\", as an inline table: what is read for the abscissa.",
          observed_keys()};
}

void read_series(Fields& root, StudyReading& reading) {
  for (Fields& fields : root.tables("series")) one_series(fields, reading);
}

}  // namespace femsph::compare
