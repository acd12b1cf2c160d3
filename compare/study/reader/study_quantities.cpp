// [[quantities]] of a study: the numbers to take from every run.

#include <fmt/format.h>

#include <algorithm>

#include "compare/measure/reductions.hpp"
#include "compare/reference/theory.hpp"
#include "compare/study/reader/study_observed.hpp"
#include "compare/study/reader/study_page.hpp"
#include "compare/study/reader/study_reading.hpp"

namespace femsph::compare {
namespace {

const std::vector<std::pair<std::string, SignRule>> signs = {
    {"as-is", SignRule::as_is}, {"reversed", SignRule::reversed}, {"magnitude", SignRule::magnitude}};

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

/// A window needs a history, and must end within the duration of every scene.
void check_window(Fields& fields, const QuantitySpec& quantity, const Study& study) {
  if (!quantity.window) return;
  if (!quantity.observed.section.empty() || !quantity.observed.scalar.empty())
    return fields.fault("window",
                        "\"window\" with a section or a scalar, which have no history; expected it with a "
                        "probe, a column or an energy");
  for (const auto& [file, scene] : study.scenes)
    if ((!quantity.scene || *quantity.scene == file) && (*quantity.window)[1] > scene.duration * (1 + 1e-9))
      fields.fault("window", fmt::format("\"window\" ends at {:.6g} ms, and the run of {} at {:.6g} ms; "
                                         "expected a window within the run",
                                         1e3 * (*quantity.window)[1], file, 1e3 * scene.duration));
}

/// A key that the reduction would ignore must not be given.
void check_fit(Fields& fields, const QuantitySpec& quantity) {
  if (quantity.reduce == Reduce::excess &&
      (quantity.theory || quantity.reference || quantity.sign != SignRule::as_is || quantity.offset != 0))
    fields.fault("reduce",
                 "\"excess\" is measured from the yield curve of the material; expected it without theory, "
                 "reference, sign and offset");
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

/// No two numbers of one run have one name: a claim, a price or a bound could not tell them apart.
void check_twice(Fields& fields, const QuantitySpec& quantity, const Study& study) {
  for (const PlannedRun& run : study.runs)
    if (quantity.is_of(run))
      for (const QuantitySpec& other : study.quantities)
        if (other.name == quantity.name && other.is_of(run))
          return fields.fault(
              "name", fmt::format("two quantities of the run {} {} are called {}; expected different names",
                                  run.case_name, run.label, in_quotes(quantity.name)));
}

/// reference_file = "reference/x.csv": a history to compare with, instead of a theory.
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

/// There is something to compare with, and the reduction fits what is read.
void check_reduction(Fields& fields, const QuantitySpec& quantity, const StudyReading& reading) {
  const Study& study = reading.study;
  const bool history_l2 = quantity.reduce == Reduce::l2 &&
                          !quantity.observed.probe.empty();  // against a theory over time
  if (history_l2 && !quantity.table && !(quantity.theory && theory_named(*quantity.theory).on_time()))
    fields.fault("reduce",
                 "l2 of a probe compares its whole history; expected \"theory\" with one that depends on "
                 "time, or \"reference_file\"");
  if (!history_l2 && quantity.observed.section.empty() == reduction_of(quantity.reduce).of_section)
    fields.fault("reduce",
                 "\"reduce\" does not fit; expected fibre_upper, fibre_lower, l2 or moment for a section, "
                 "and one of the others for a probe or an energy");
  if (quantity.reduce == Reduce::l2 && !quantity.theory && !quantity.table && !study.limit &&
      study.limits.empty() && reading.limits_known)
    fields.fault("reduce", "l2 has nothing to compare with; expected \"theory\", or [limit] in the study");
}

void one_quantity(Fields& fields, StudyReading& reading) {
  QuantitySpec quantity;
  const auto name = fields.text("name", Need::required, "a name for the tables");
  if (!name) reading.quantities_known = false;
  quantity.name = name.value_or("");
  quantity.scene = read_scene_name(fields, Need::optional, reading);
  quantity.methods = read_names(
      fields, "methods", method_labels(reading.study), "method", reading.runs_known);
  const auto reduce = fields.choice<Reduce>("reduce", Need::optional, reduction_words());
  if ((fields.has("reduce") && !reduce) ||
      fields.misspelt({"scene", "methods", "reduce", "probe", "section", "energy", "scalar", "column",
                       "component", "theory", "reference", "reference_file"})) {
    reading.quantities_known = false;
    return fields.accept_rest(), fields.done();  // other keys depend on it
  }
  quantity.reduce = reduce.value_or(Reduce::final);
  const std::string si = reduction_of(quantity.reduce).unit;
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
      fields.fault(
          "window", "\"window\" is not an interval; expected two times, such as [\"10 us\", \"20 us\"]");
  }
  fields.done();
  check_window(fields, quantity, reading.study);
  check_fit(fields, quantity);
  check_twice(fields, quantity, reading.study);
  check_reduction(fields, quantity, reading);
  reading.study.quantities.push_back(quantity);
}

}  // namespace

KeyTable quantity_keys() {
  return {
      "[[quantities]]", "A number to take from every run: one row of the table for each.",
      joined(joined({{"name", key_holds::text, "The name in tables.", true}}, observed_keys()),
             {{"reduce", key_holds::words(reduction_words()),
               "How the history or profile is reduced to one number: see below. \"final\" unless given."},
              {"sign", key_holds::words(signs),
               "How value, theory and limit are shown. \"as-is\" unless given."},
              {"window", key_holds::quantities(dimension::time),
               "Two times: only this part of a history is used."},
              theory_key(),
              {"reference", "a number with the unit of the quantity in quotes; a number where that is 1 or %",
               "A value to compare with, instead of a theory."},
              {"reference_file", "a text: a CSV file beside the study, \"time [s],NAME [unit]\" above",
               "With \"l2\" of a probe: a history to compare with, instead of a theory."},
              {"offset", "a number with the unit of the quantity in quotes; a number where that is 1 or %",
               "Added to the value, such as the initial length to a displacement; only with \"reference\" or "
               "without a comparison."},
              scene_key("Only of runs of that scene."),
              {"methods", key_holds::texts, "Only of runs with these labels (names of methods in tables)."}}),
      "reduce", reduction_entries()};
}

KeyTable quantity_along_keys() {
  return {"[quantities.along]",
          "With reduce = \"excess\", as an inline table: the equivalent plastic strain p.", observed_keys()};
}

void read_quantities(Fields& root, StudyReading& reading) {
  if (root.misspelt({"quantities"})) reading.quantities_known = false;
  for (Fields& fields : root.tables("quantities")) one_quantity(fields, reading);
}

}  // namespace femsph::compare
