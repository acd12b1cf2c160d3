// [[quantities]] and [[series]] of a study: what to take from a run.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "compare/reference/theory.hpp"
#include "compare/run/plan/run_result.hpp"
#include "compare/study/reader/study_page.hpp"
#include "compare/study/reader/study_reading.hpp"
#include "model/input/units.hpp"
#include "model/results/history_columns.hpp"

namespace femsph::compare {
namespace {

const std::vector<std::pair<std::string, Reduce>> reductions = {
    {"final", Reduce::final},
    {"max", Reduce::max},
    {"min", Reduce::min},
    {"peak", Reduce::peak},
    {"mean", Reduce::mean},
    {"frequency", Reduce::frequency},
    {"period", Reduce::period},
    {"integral", Reduce::integral},
    {"duration", Reduce::duration},
    {"fibre_upper", Reduce::fibre_upper},
    {"fibre_lower", Reduce::fibre_lower},
    {"l2", Reduce::l2},
    {"moment", Reduce::moment},
    {"excess", Reduce::excess}};
const std::vector<std::pair<std::string, SeriesSpec::Kind>> series_kinds = {
    {"error", SeriesSpec::Kind::error},
    {"cases", SeriesSpec::Kind::cases},
    {"history", SeriesSpec::Kind::history},
    {"profile", SeriesSpec::Kind::profile},
    {"path", SeriesSpec::Kind::path}};
const std::vector<std::pair<std::string, Reference>> series_references = {
    {"theory", Reference::theory}, {"limit", Reference::limit}, {"value", Reference::value}};
const std::vector<std::pair<std::string, SignRule>> signs = {
    {"as-is", SignRule::as_is}, {"reversed", SignRule::reversed}, {"magnitude", SignRule::magnitude}};
std::vector<std::string> scalar_names() {
  std::vector<std::string> names;
  for (const auto& [name, si] : run_scalars()) names.push_back(name);
  return names;
}

std::string scalar_unit(const std::string& scalar) {
  for (const auto& [name, si] : run_scalars())
    if (name == scalar) return si;
  return "1";
}

/// The unit of a column of the history, which some scene asked must have: all of them when `scene` names
/// none.
std::string column_unit(const Fields& fields, const std::string& column,
                        const std::optional<std::string>& scene, const Study& study) {
  std::vector<std::string> known;
  for (const auto& [file, read] : study.scenes) {
    if (scene && *scene != file) continue;
    for (const Column& c : history_columns(read).columns) {
      if (c.name == column) return c.unit;
      if (std::find(known.begin(), known.end(), c.name) == known.end()) known.push_back(c.name);
    }
  }
  if (!known.empty())
    fields.fault("column", fmt::format("no column of a history is called {}; expected {}{}",
                                       in_quotes(column), one_of(known), did_you_mean(column, known)));
  return "";
}

/// Of [[quantities]], [[series]] and their "along": what is read.
std::vector<Key> observed_keys() {
  return {
      {"probe", "a text: a probe of the scene",
       "One of \"probe\", \"section\", \"energy\", \"scalar\" and \"column\" says what is read."},
      {"section", "a text: a section of the scene", "The profile at the last sample."},
      {"energy", "a text: " + one_of(energy_columns()), "A column of energy."},
      {"scalar", "a text: " + one_of(scalar_names()), "One number of the whole run."},
      {"column", "a text: a column of the history, such as \"contact_blow_force_x\"", "Any other column."},
      {"component", "a text: x, xx, 1 or the like", "Of a probe or a section; not of a scalar."},
      {"unit", "a text: a unit of the same kind, such as \"mm\"", "In tables. SI unless given."}};
}

std::vector<Key> joined(std::vector<Key> all, const std::vector<Key>& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

Key theory_key() { return {"theory", "a text: a theory value", "To compare with: see `femsph list`."}; }
Key scene_key(const char* about) { return {"scene", "a text: the file of a scene that a run uses", about}; }

bool of_section(Reduce reduce) {
  return reduce == Reduce::fibre_upper || reduce == Reduce::fibre_lower || reduce == Reduce::l2 ||
         reduce == Reduce::moment;
}

template <class T>
std::optional<const Quantity*> observer(const std::vector<T>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const T& o) { return o.name == name; });
  return found == list.end() ? std::nullopt : std::optional(found->quantity);
}

/// What a probe or a section of this name reads, and the components that it has in every scene asked.
struct Found {
  const Quantity* quantity;
  std::vector<std::string> components;
};

// The probe or section must be in every scene that `scene` names, and read the same there: all of them when
// it names none.
std::optional<Found> find_observer(Fields& fields, const char* key, const std::string& name,
                                   const std::optional<std::string>& scene, const Study& study) {
  std::optional<Found> found;
  const bool section = std::string(key) == "section";
  for (const auto& [file, read] : study.scenes) {
    if (scene && *scene != file) continue;
    const auto quantity = section ? observer(read.sections, name) : observer(read.probes, name);
    if (quantity && found && found->quantity != *quantity) {
      fields.fault(key, fmt::format("the {} {} reads one quantity in {} and another in other scenes; "
                                    "expected \"scene\", which says whose it is",
                                    key, in_quotes(name), file));
      return {};
    }
    if (quantity) {
      const auto names = component_names(**quantity, read.dim());
      if (!found || names.size() < found->components.size()) found = {*quantity, names};
      continue;
    }
    std::vector<std::string> names;
    if (section)
      for (const Section& s : read.sections) names.push_back(s.name);
    else
      for (const Probe& p : read.probes) names.push_back(p.name);
    fields.fault(
        key, fmt::format("no {} is called {} in {}{}{}", key, in_quotes(name), file,
                         names.empty() ? "" : "; expected " + one_of(names), did_you_mean(name, names)));
    return {};
  }
  return found;
}

Unit read_unit(Fields& fields, const char* key, const std::optional<std::string>& name,
               const std::string& si) {
  if (!name) return {si, 1};
  try {
    return unit_named(*name, si);
  } catch (const std::invalid_argument&) {
    fields.fault(key, fmt::format("\"{}\" is {}; expected a unit of the same kind as {}", key,
                                  in_quotes(*name), in_quotes(si)));
    return {*name, 1};
  }
}

Observed read_observed(Fields& fields, const std::optional<std::string>& scene,
                       const std::string& si_of_reduced, const Study& study) {
  Observed observed;
  const auto probe = fields.text("probe", Need::optional), section = fields.text("section", Need::optional);
  const auto energy = fields.text("energy", Need::optional), scalar = fields.text("scalar", Need::optional);
  const auto column = fields.text(
      "column", Need::optional, "a column of the history, such as \"contact_blow_force_x\"");
  const auto component = fields.text("component", Need::optional);
  const auto unit = fields.text("unit", Need::optional, "a unit such as \"mm\"");
  observed.probe = probe.value_or("");
  observed.section = section.value_or("");
  observed.column = energy ? *energy : column.value_or("");
  observed.scalar = scalar.value_or("");
  if (probe.has_value() + section.has_value() + energy.has_value() + scalar.has_value() +
          column.has_value() !=
      1) {
    fields.fault(
        "probe",
        "expected one of \"probe\", \"section\", \"energy\", \"scalar\" and \"column\" in " + fields.name());
    return observed;
  }
  std::string si = scalar ? scalar_unit(*scalar) : column ? column_unit(fields, *column, scene, study) : "J";
  if (const auto known = scalar_names();
      scalar && std::find(known.begin(), known.end(), *scalar) == known.end()) {
    fields.fault("scalar", fmt::format("unknown scalar {}; expected {}{}", in_quotes(*scalar), one_of(known),
                                       did_you_mean(*scalar, known)));
    return observed;
  }
  if (column && si.empty()) return observed;
  const std::vector<std::string>& energies = energy_columns();
  if (energy && std::find(energies.begin(), energies.end(), *energy) == energies.end())
    fields.fault("energy", fmt::format("unknown energy {}; expected {}{}", in_quotes(*energy),
                                       one_of(energies), did_you_mean(*energy, energies)));
  if (probe || section) {
    const char* key = probe ? "probe" : "section";
    const auto found = find_observer(fields, key, probe ? *probe : *section, scene, study);
    if (!found) return observed;
    const auto& known = found->components;
    observed.component = component.value_or(known.size() == 1 ? known[0] : "");
    if (std::find(known.begin(), known.end(), observed.component) == known.end())
      fields.fault(
          component ? "component" : key,
          fmt::format("the component is {}; expected {}", in_quotes(observed.component), one_of(known)));
    si = found->quantity->unit;
  }
  observed.unit = read_unit(fields, "unit", unit, si_of_reduced.empty() ? si : si_of_reduced);
  observed.si = si;
  return observed;
}

// The theory must be able to speak of every scene that it will be asked for, and of what is read: better said
// now than after the runs.
std::optional<std::string> read_theory(Fields& fields, const std::optional<std::string>& scene,
                                       const std::string& si, bool over_time, const Study& study) {
  const auto name = fields.text("theory", Need::optional, "the name of a theory value");
  if (!name) return {};
  try {
    const Theory& theory = theory_named(*name);
    if (theory.on_time() && !over_time) {
      fields.fault(
          "theory", "a theory that depends on time; expected one value (a history goes into [[series]])");
      return {};
    }
    for (const auto& [file, read] : study.scenes)
      if (!scene || *scene == file) theory.value(read, read.bodies[0].shape->lower(), 0);
    if (!si.empty() && theory.unit != si) {
      fields.fault(
          "theory", fmt::format("{} is in {}, and what is read is in {}; expected a theory of the same kind",
                                theory.name, theory.unit, si));
      return {};
    }
    return theory.name;
  } catch (const std::runtime_error& e) {
    fields.fault("theory", e.what());
    return {};
  }
}

/// A number in the unit of the table, such as reference = "25.18 mm", or a plain number where the unit is 1
/// or %.
std::optional<double> read_in_unit(Fields& fields, const char* key, const Unit& unit) {
  if (unit.name == "1" || unit.name == "%" || unit.name == "1e-6")
    return fields.number(
        key, Need::optional, fmt::format("a number in the unit of the quantity, {}", unit.name));
  return fields.quantity(
      key, Need::optional,
      Dimension{unit.name.c_str(), "a number with the unit of the quantity", unit.name.c_str()});
}

/// A window is of a history, and within the run of every scene.
void check_window(Fields& fields, const QuantitySpec& quantity, const Study& study) {
  if (!quantity.window) return;
  if (!quantity.observed.section.empty() || !quantity.observed.scalar.empty())
    return fields.fault("window",
                        "\"window\" with a section or a scalar, which have no history; expected it with a "
                        "probe, a column or an energy");
  for (const auto& [file, scene] : study.scenes)
    if ((!quantity.scene || *quantity.scene == file) && (*quantity.window)[1] > scene.duration * (1 + 1e-9))
      fields.fault(
          "window",
          fmt::format(
              "\"window\" goes on to {:.6g} ms, and {} to {:.6g} ms; expected a window within the run",
              1e3 * (*quantity.window)[1], file, 1e3 * scene.duration));
}

/// What a reduction would not look at must not be given.
void check_fit(Fields& fields, const QuantitySpec& quantity) {
  if (quantity.reduce == Reduce::excess &&
      (quantity.theory || quantity.reference || quantity.sign != SignRule::as_is || quantity.offset != 0))
    fields.fault("reduce",
                 "excess is measured from its own yield curve; expected it without theory, reference, sign "
                 "and offset");
  if (quantity.reduce == Reduce::l2 && (quantity.reference || quantity.sign != SignRule::as_is))
    fields.fault("reduce", "l2 is a distance from theory or limit; expected it without reference and sign");
  if (!quantity.observed.scalar.empty() && quantity.reduce != Reduce::final)
    fields.fault("reduce", "a scalar is one number of the whole run; expected no \"reduce\"");
  if (quantity.reduce == Reduce::integral && !quantity.observed.si.empty() && quantity.observed.si != "N")
    fields.fault(
        "reduce", fmt::format("the integral over time is that of a force, in N s; what is read is in {}",
                              quantity.observed.si));
  if (quantity.reduce == Reduce::moment && quantity.observed.component != "xx")
    fields.fault(
        "component", fmt::format("a moment is of the stress xx, and the component is {}; expected \"xx\"",
                                 in_quotes(quantity.observed.component)));
}

/// Two numbers of one run under one name: a claim, a price or a bound would take either.
void check_twice(Fields& fields, const QuantitySpec& quantity, const Study& study) {
  for (const PlannedRun& run : study.runs)
    if (quantity.is_of(run))
      for (const QuantitySpec& other : study.quantities)
        if (other.name == quantity.name && other.is_of(run))
          return fields.fault(
              "name", fmt::format("two quantities of the run {} {} are called {}; expected a name for each",
                                  run.case_name, run.label, in_quotes(quantity.name)));
}

/// reference_file = "reference/x.csv": a history to compare with, in place of a theory.
std::optional<ReferenceTable> read_table(Fields& fields, const QuantitySpec& quantity,
                                         const StudyReading& reading) {
  const auto file = fields.text(
      "reference_file", Need::optional, "a CSV file, \"time [s],NAME [unit]\" above, beside the study");
  if (!file) return {};
  if (quantity.reduce != Reduce::l2 || quantity.observed.probe.empty() || quantity.theory)
    fields.fault(
        "reference_file",
        "\"reference_file\" holds a whole history; expected reduce = \"l2\", a \"probe\", and no \"theory\"");
  try {
    return read_reference_table(reading.study.folder + "/" + *file, quantity.observed.si);
  } catch (const std::runtime_error& e) {
    fields.fault("reference_file", e.what());
    return ReferenceTable{};
  }
}

void one_quantity(Fields& fields, StudyReading& reading) {
  QuantitySpec quantity;
  const auto name = fields.text("name", Need::required, "a name for the tables");
  if (!name) reading.quantities_known = false;
  quantity.name = name.value_or("");
  quantity.scene = read_scene_name(fields, Need::optional, reading);
  quantity.methods = read_names(
      fields, "methods", method_labels(reading.study), "method", reading.runs_known);
  const auto reduce = fields.choice<Reduce>("reduce", Need::optional, reductions);
  quantity.reduce = reduce.value_or(Reduce::final);
  const std::string si = quantity.reduce == Reduce::frequency                                       ? "Hz"
                         : quantity.reduce == Reduce::period || quantity.reduce == Reduce::duration ? "s"
                         : quantity.reduce == Reduce::integral                                      ? "N s"
                         : quantity.reduce == Reduce::l2                                            ? "1"
                         : quantity.reduce == Reduce::moment                                        ? "N m"
                                                                                                    : "";
  quantity.observed = read_observed(fields, quantity.scene, si, reading.study);
  if (quantity.reduce == Reduce::l2) quantity.observed.unit = {"%", 1};
  if (quantity.reduce == Reduce::excess) {
    quantity.observed.unit = {"%", 0.01};
    auto along = fields.table(
        "along", Need::required, "a table such as {probe = \"plastic\", component = \"equivalent\"}");
    if (along) quantity.along = read_observed(*along, quantity.scene, "", reading.study), along->done();
  }
  quantity.sign = fields.choice<SignRule>("sign", Need::optional, signs).value_or(SignRule::as_is);
  // l2 compares what is read itself; the others what `reduce` makes of it.
  quantity.theory = read_theory(
      fields, quantity.scene, si.empty() || quantity.reduce == Reduce::l2 ? quantity.observed.si : si,
      quantity.reduce == Reduce::l2 && !quantity.observed.probe.empty(), reading.study);
  quantity.table = read_table(fields, quantity, reading);
  quantity.reference = read_in_unit(fields, "reference", quantity.observed.unit);
  if (const auto offset = read_in_unit(fields, "offset", quantity.observed.unit)) {
    quantity.offset = *offset;
    if (quantity.theory || reading.study.limit || !reading.study.limits.empty())
      fields.fault("offset",
                   "\"offset\" moves the value away from theory and limit; expected a quantity with a "
                   "\"reference\" or none");
  }
  if (quantity.theory && quantity.reference)
    fields.fault("reference", "both \"theory\" and \"reference\"; expected one of them");
  if (const auto window = fields.quantities("window", Need::optional, dimension::time)) {
    if (window->size() == 2 && (*window)[0] < (*window)[1])
      quantity.window = {(*window)[0], (*window)[1]};
    else
      fields.fault("window", "\"window\" is no interval; expected two times, such as [\"10 us\", \"20 us\"]");
  }
  fields.done();
  check_window(fields, quantity, reading.study);
  check_fit(fields, quantity);
  check_twice(fields, quantity, reading.study);
  const bool history_l2 = quantity.reduce == Reduce::l2 &&
                          !quantity.observed.probe.empty();  // against a theory over time
  if (history_l2 && !quantity.table && !(quantity.theory && theory_named(*quantity.theory).on_time()))
    fields.fault("reduce",
                 "l2 of a probe compares its whole history; expected \"theory\" with one that depends on "
                 "time, or \"reference_file\"");
  if (!history_l2 && quantity.observed.section.empty() == of_section(quantity.reduce))
    fields.fault("reduce",
                 "\"reduce\" does not fit; expected fibre_upper, fibre_lower, l2 or moment for a section, "
                 "and one of the others for a probe or an energy");
  if (quantity.reduce == Reduce::l2 && !quantity.theory && !quantity.table && !reading.study.limit &&
      reading.study.limits.empty())
    fields.fault("reduce", "l2 has nothing to compare with; expected \"theory\", or [limit] in the study");
  reading.study.quantities.push_back(quantity);
}

std::string read_file_name(Fields& fields) {
  const std::string expected = "a file name of letters, digits, ., _ and -, ending in .csv";
  const auto file = fields.text("file", Need::required, expected);
  if (!file) return "";
  const auto allowed = [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) || c == '_' || c == '-' || c == '.');
  };
  if (!std::all_of(file->begin(), file->end(), allowed) || !file->ends_with(".csv") || file->starts_with("."))
    fields.fault("file", fmt::format("\"file\" is {}; expected {}", in_quotes(*file), expected));
  return *file;
}

void one_series(Fields& fields, StudyReading& reading) {
  using Kind = SeriesSpec::Kind;
  const Study& study = reading.study;
  SeriesSpec series;
  series.file = read_file_name(fields);
  series.kind = fields.choice("kind", Need::required, series_kinds).value_or(Kind::error);
  series.cases = read_names(fields, "cases", case_names(study), "case", reading.runs_known);
  series.methods = read_names(fields, "methods", method_labels(study), "method", reading.runs_known);
  if (series.kind == Kind::error || series.kind == Kind::cases) {
    const auto known = quantity_names(study);
    series.quantity = fields.text("quantity", Need::required, one_of(known)).value_or("");
    series.reference =
        fields.choice("reference", Need::optional, series_references).value_or(Reference::theory);
    if (!series.quantity.empty())
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
    if (series.observed.section.empty() == (series.kind == Kind::profile))
      fields.fault("kind",
                   "\"kind\" does not fit; expected \"profile\" with a section, \"history\" with a probe or "
                   "an energy");
  }
  fields.done();
  reading.study.series.push_back(series);
}

}  // namespace

KeyTable quantity_keys() {
  return {
      "[[quantities]]", "A number to take from every run: one row of the table for each.",
      joined(
          joined({{"name", key_holds::text, "In tables.", true}}, observed_keys()),
          {{"reduce", key_holds::words(reductions),
            "What is made of a history: its last value (unless given), extremes, the largest magnitude, the "
            "mean, the frequency or period, the integral over time (of a force), the time from the first to "
            "the last value that is not zero; of a section: its upper or lower end, the distance \"l2\" from "
            "theory or limit in percent (of a probe: of its history), the \"moment\" of its stress; "
            "\"excess\": how far an equivalent stress lies above its yield curve."},
           {"sign", key_holds::words(signs), "Of value, theory and limit alike. \"as-is\" unless given."},
           {"window", key_holds::quantities(dimension::time), "Two times: the part of a history to look at."},
           theory_key(),
           {"reference", "a number with the unit of the quantity in quotes; a number where that is 1 or %",
            "To compare with, in place of a theory."},
           {"reference_file", "a text: a CSV file beside the study, \"time [s],NAME [unit]\" above",
            "With \"l2\" of a probe: a history to compare with, in place of a theory."},
           {"offset", "a number with the unit of the quantity in quotes; a number where that is 1 or %",
            "Added to the value; with \"reference\" or nothing to compare with."},
           scene_key("Only of runs of that scene."),
           {"methods", key_holds::texts, "Only of runs with these labels."}})};
}

KeyTable quantity_along_keys() {
  return {"[quantities.along]", "With \"excess\", inline: the equivalent plastic strain.", observed_keys()};
}

KeyTable series_keys() {
  return {
      "[[series]]", "A file under data/ for figures.",
      joined({{"file", key_holds::text, "Its name, ending in .csv.", true},
              {"kind", key_holds::words(series_kinds),
               "The error of a quantity over spacings, or over cases; a history; the profile of a section; "
               "or a path: one history over another.",
               true},
              {"cases", key_holds::texts, "Of these cases."},
              {"methods", key_holds::texts, "Of these labels."},
              {"quantity", "a text: a quantity of this study", "Whose error.", false,
               "with kind \"error\" or \"cases\""},
              {"reference", key_holds::words(series_references), "Of the errors. \"theory\" unless given."},
              scene_key("Whose theory. The first run's unless given."),
              theory_key(),
              {"time_unit", "a text: a unit of time", "Of a history. \"ms\" unless given."}},
             observed_keys())};
}

KeyTable series_along_keys() {
  return {"[series.along]", "With kind \"path\", inline: what the abscissa is.", observed_keys()};
}

void read_quantities(Fields& root, StudyReading& reading) {
  for (Fields& fields : root.tables("quantities")) one_quantity(fields, reading);
}

void read_series(Fields& root, StudyReading& reading) {
  for (Fields& fields : root.tables("series")) one_series(fields, reading);
}

}  // namespace femsph::compare
