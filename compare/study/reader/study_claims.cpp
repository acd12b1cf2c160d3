// [[paper]] and [[claims]] of a study: numbers that the paper reports, and statements of the paper to check.

#include <fmt/format.h>

#include <algorithm>

#include "compare/study/reader/study_page.hpp"
#include "compare/study/reader/study_reading.hpp"
#include "model/input/lookup.hpp"
#include "model/input/units.hpp"

namespace femsph::compare {
namespace {

using Kind = Claim::Kind;

const std::vector<std::pair<std::string, Kind>> claim_kinds = {
    {"value", Kind::value}, {"below", Kind::below}, {"above", Kind::above},   {"ratio", Kind::ratio},
    {"order", Kind::order}, {"finer", Kind::finer}, {"larger", Kind::larger}, {"smaller", Kind::smaller}};
const std::vector<std::pair<std::string, Reference>> claim_references = {
    {"theory", Reference::theory}, {"limit", Reference::limit}, {"value", Reference::value}};
const std::vector<std::pair<std::string, bool>> claim_fields = {{"error", false}, {"value", true}};

std::vector<Key> filter_keys(bool quantity_required) {
  return {{"study", key_holds::text, "Rows of this study."},
          {"cases", key_holds::texts, "Rows of these cases."},
          {"method", "a text: the name of a method in tables", "Rows of this method."},
          {"quantity", "a text: a quantity of the study", "Rows of this quantity.", false,
           quantity_required ? "here" : ""},
          {"spacing", key_holds::quantity(dimension::length), "Rows of this spacing."}};
}

void add_planned(const Study& study, std::vector<Row>& rows) {
  for (const PlannedRun& run : study.runs)
    for (const QuantitySpec& quantity : study.quantities) {
      if (!quantity.is_of(run)) continue;
      Row row;
      row.study = study.name, row.case_name = run.case_name, row.method = run.label,
      row.quantity = quantity.name;
      row.unit = quantity.observed.unit.name;
      if (run.resolution.spacing > 0) row.spacing_mm = 1e3 * run.resolution.spacing;
      rows.push_back(row);
    }
}

/// The rows that the study will have, without their numbers: a filter that matches none of them is a mistake,
/// unless an earlier fault hides some rows (`complete` is false).
struct Planned {
  std::vector<Row> rows;
  bool complete;
};
Planned planned_rows(const StudyReading& reading) {
  Planned planned{{}, reading.runs_known && reading.quantities_known};
  add_planned(reading.study, planned.rows);
  for (const Study& other : reading.study.collected) add_planned(other, planned.rows);
  return planned;
}

bool could_match(RowFilter filter, const Row& planned) {
  if (!planned.spacing_mm)
    filter.spacing_mm.reset();  // from divisions: the spacing is known only after the run
  return filter.matches(planned);
}

std::vector<std::string> known_words(std::string Row::*member, const Planned& planned) {
  std::vector<std::string> known;
  for (const Row& row : planned.rows)
    if (std::find(known.begin(), known.end(), row.*member) == known.end()) known.push_back(row.*member);
  return known;
}

/// One word of a filter: some row must have it.
std::optional<std::string> read_word(Fields& fields, const char* key, std::string Row::*member,
                                     const Planned& planned) {
  const auto word = fields.text(key, Need::optional);
  if (!word) return {};
  const auto known = known_words(member, planned);
  if (!planned.complete || std::find(known.begin(), known.end(), *word) != known.end()) return word;
  fields.fault(
      key, fmt::format("no run has the {} {}{}", key, in_quotes(*word), expected_names(*word, known)));
  return {};
}

RowFilter read_filter(Fields& fields, const Planned& planned) {
  RowFilter filter;
  filter.study = read_word(fields, "study", &Row::study, planned);
  filter.cases = read_names(fields, "cases", known_words(&Row::case_name, planned), "case", planned.complete);
  filter.method = read_word(fields, "method", &Row::method, planned);
  filter.quantity = read_word(fields, "quantity", &Row::quantity, planned);
  if (const auto spacing = fields.quantity("spacing", Need::optional, dimension::length, Sign::positive))
    filter.spacing_mm = 1e3 * *spacing;
  return filter;
}

void check_filter(const Fields& fields, const char* key, const RowFilter& filter, const Planned& planned) {
  const bool some = std::any_of(
      planned.rows.begin(), planned.rows.end(), [&](const Row& row) { return could_match(filter, row); });
  if (!some && planned.complete)
    fields.fault(key, fmt::format("no run of the study gives {}; expected words of one run together",
                                  filter.describe()));
}

RowFilter read_filter_table(Fields& claim, const char* key, const Planned& planned) {
  auto fields = claim.table(
      key, Need::required, "a table such as {cases = [\"1_4\"], quantity = \"tip_displacement\"}");
  if (!fields) return {};
  const RowFilter filter = read_filter(*fields, planned);
  fields->done();
  check_filter(claim, key, filter, planned);
  return filter;
}

double positive(Fields& fields, const char* key, double least) {
  const auto value = fields.number(key, Need::required);
  if (value && *value < least)
    fields.fault(key, fmt::format("\"{}\" is {}; expected a number from {} on", key, *value, least));
  return value.value_or(least);
}

/// The keys that this kind of claim needs, and no others.
void read_kind(Fields& fields, Claim& claim, const Planned& planned) {
  const auto paper = [&] {
    claim.paper = fields.number("paper", Need::required, "the paper's number").value_or(0);
  };
  claim.rows = read_filter_table(fields, "rows", planned);
  switch (claim.kind) {
    case Kind::value:
      claim.of_value = fields.choice("field", Need::optional, claim_fields).value_or(false);
      paper();
      claim.tolerance = positive(fields, "tolerance", 0);
      break;
    case Kind::below:
    case Kind::above:
      claim.bound = positive(fields, "bound", 0);
      break;
    case Kind::ratio:
    case Kind::finer:
      claim.other = read_filter_table(fields, "other", planned);
      paper();
      claim.factor = positive(fields, "factor", 1);
      break;
    case Kind::order:
      claim.low = fields.number("low", Need::required).value_or(0);
      claim.high = fields.number("high", Need::required).value_or(0);
      if (claim.low > claim.high) fields.fault("low", "\"low\" is above \"high\"; expected it below");
      break;
    case Kind::larger:
    case Kind::smaller:
      break;
  }
}

void one_claim(Fields& fields, StudyReading& reading, const Planned& planned) {
  Claim claim;
  claim.id = fields.text("id", Need::required, "a short name").value_or("");
  claim.source =
      fields.text("source", Need::required, "the place in the paper, such as \"fig 5\"").value_or("");
  claim.text = fields.text("text", Need::required, "the claim in words").value_or("");
  claim.note = fields.text("note", Need::optional).value_or("");
  claim.reference = fields.choice("reference", Need::optional, claim_references).value_or(Reference::theory);
  const auto kind = fields.choice("kind", Need::required, claim_kinds);
  if (!kind) return fields.accept_rest(), fields.done();
  claim.kind = *kind;
  read_kind(fields, claim, planned);
  fields.done();
  reading.study.claims.push_back(claim);
}

std::optional<double> read_paper_value(Fields& fields, const std::optional<std::string>& quantity,
                                       const Study& study) {
  const auto text = fields.text(
      "value", Need::optional, "a number with the unit of the quantity, such as \"4.765 mm\"");
  const auto spec = std::find_if(study.quantities.begin(), study.quantities.end(),
                                 [&](const QuantitySpec& q) { return q.name == quantity; });
  if (!text || spec == study.quantities.end()) return {};
  const std::string& unit = spec->observed.unit.name;
  try {
    return to_si(*text, Dimension{unit.c_str(), "a number with its unit", unit.c_str()});
  } catch (const std::invalid_argument& e) {
    fields.fault("value", fmt::format("\"value\": {}", e.what()));
    return {};
  }
}

}  // namespace

KeyTable paper_keys() {
  KeyTable table{"[[paper]]", "A number that the paper reports; it is shown in the rows that it belongs to.",
                 filter_keys(true)};
  for (const Key& key : std::vector<Key>{
           {"value", "a text: a number with the unit of the quantity, such as \"4.765 mm\"",
            "The paper's value. This, \"error_percent\" or both."},
           {"error_percent", key_holds::number, "The error that the paper states."},
           {"source", key_holds::text, "The place in the paper, such as \"fig 14\".", true}})
    table.keys.push_back(key);
  return table;
}

KeyTable claim_keys() {
  const std::string of_ratio = "with kind \"ratio\" or \"finer\"", of_order = "with kind \"order\"";
  return {
      "[[claims]]",
      "A statement of the paper that is checked with the rows of the table.",
      {{"id", key_holds::text, "A short name.", true},
       {"source", key_holds::text, "The place in the paper, such as \"fig 5\".", true},
       {"text", key_holds::text, "The claim in words.", true},
       {"note", key_holds::text, "Shown if the claim does not hold."},
       {"reference", key_holds::words(claim_references),
        "What the errors are measured against. \"theory\" unless given."},
       {"kind", key_holds::words(claim_kinds),
        "How it is checked. \"value\": error or value is the paper's, within \"tolerance\"; \"below\", "
        "\"above\": a bound on the error; \"ratio\": the ratio of the errors of two rows; \"order\": the "
        "observed order of convergence; \"finer\": how many times finer the rows must be for the error of "
        "another row; \"larger\", \"smaller\": than the reference.",
        true},
       {"field", key_holds::words(claim_fields),
        "With \"value\": what is compared with \"paper\". \"error\" unless given."},
       {"paper", key_holds::number, "The paper's number.", false,
        "with kind \"value\", \"ratio\" or \"finer\""},
       {"tolerance", key_holds::number, "How far the number may be from the paper's.", false,
        "with kind \"value\""},
       {"bound", key_holds::number, "Percent.", false, "with kind \"below\" or \"above\""},
       {"factor", key_holds::number, "The ratio may differ from \"paper\" by this factor, 1 or more.", false,
        of_ratio},
       {"low", key_holds::number, "The least order.", false, of_order},
       {"high", key_holds::number, "The largest order.", false, of_order}}};
}

KeyTable claim_rows_keys() {
  return {"[claims.rows]",
          "The rows that the claim is about, as an inline table: rows = {cases = [\"1_4\"], quantity = "
          "\"tip_displacement\"}.",
          filter_keys(false),
          {},
          {},
          true};
}

KeyTable claim_other_keys() {
  return {"[claims.other]",
          "With kind \"ratio\" or \"finer\", as an inline table: the row that they are compared with.",
          filter_keys(false)};
}

void read_paper(Fields& root, StudyReading& reading) {
  const auto planned = planned_rows(reading);
  for (Fields& fields : root.tables("paper")) {
    PaperNumber number;
    number.rows = read_filter(fields, planned);
    if (!fields.has("quantity"))
      fields.text("quantity", Need::required, "the quantity that the number is for");
    number.value = read_paper_value(fields, number.rows.quantity, reading.study);
    number.error_percent = fields.number("error_percent", Need::optional);
    number.source =
        fields.text("source", Need::required, "the place in the paper, such as \"fig 14\"").value_or("");
    if (!fields.has("value") && !fields.has("error_percent") && !fields.misspelt({"value", "error_percent"}))
      fields.fault("value", "expected \"value\", \"error_percent\" or both in [[paper]]");
    fields.done();
    if (number.rows.quantity) check_filter(fields, "quantity", number.rows, planned);
    reading.study.paper.push_back(number);
  }
}

void read_claims(Fields& root, StudyReading& reading) {
  const auto planned = planned_rows(reading);
  for (Fields& fields : root.tables("claims")) one_claim(fields, reading, planned);
}

}  // namespace femsph::compare
