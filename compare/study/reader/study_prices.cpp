// [[price]] and [[advice]] of a study: the CPU time that accuracy costs, and the check of `femsph advise`.

#include <fmt/format.h>

#include <algorithm>

#include "compare/study/reader/study_page.hpp"
#include "compare/study/reader/study_reading.hpp"
#include "model/input/units.hpp"

namespace femsph::compare {
namespace {

const std::vector<std::pair<std::string, Reference>> price_references = {
    {"theory", Reference::theory}, {"limit", Reference::limit}};

std::string read_name(Fields& fields, const Study& study) {
  const std::string expected = "a name of letters, digits, _ and -, as it is part of file names";
  const std::string name = fields.text("name", Need::required, expected).value_or("x");
  if (!is_file_name(name))
    fields.fault("name", fmt::format("\"name\" is {}; expected {}", in_quotes(name), expected));
  if (std::any_of(
          study.prices.begin(), study.prices.end(), [&](const PriceSpec& p) { return p.name == name; }))
    fields.fault("name", fmt::format("two prices are called {}; expected different names", in_quotes(name)));
  return name;
}

Key quantity_key() {
  return {
      "quantity", "a text: a quantity of this study, of one scene", "The quantity whose error counts.", true};
}

/// The quantity that the key "quantity" names, or null after a fault.
const QuantitySpec* read_quantity(Fields& fields, const StudyReading& reading) {
  const auto name = fields.text("quantity", Need::required, one_of(quantity_names(reading.study)));
  if (!name) return nullptr;
  for (const QuantitySpec& quantity : reading.study.quantities)
    if (quantity.name == *name) return &quantity;
  require_known(
      fields, "quantity", "quantity", *name, quantity_names(reading.study), reading.quantities_known);
  return nullptr;
}

std::string read_base(Fields& fields, const StudyReading& reading) {
  const auto base = fields.text("base", Need::optional, "the name of a method in tables");
  if (base) require_known(fields, "base", "method", *base, method_labels(reading.study), reading.runs_known);
  return base.value_or("");
}

}  // namespace

KeyTable price_keys() {
  return {
      "[[price]]",
      "The CPU time that accuracy costs by each method; studies/cost/README.md states the rules.",
      {{"name", key_holds::text, "The name in price.csv and in file names: letters, digits, _ and -.", true},
       {"title", key_holds::text, "Heading in the README. The name unless given."},
       quantity_key(),
       {"reference", key_holds::words(price_references),
        "What the error is measured against. \"limit\" unless given."},
       {"errors", key_holds::numbers, "Percents above 0. [10, 5, 1, 0.1] unless given."},
       {"spacing", key_holds::quantity(dimension::length), "All methods are also compared at this spacing."},
       {"base", "a text: the name of a method in tables",
        "The others are compared with it: how many times finer they must be for the same error, and how many "
        "times as much CPU time that costs."}}};
}

KeyTable advice_keys() {
  return {
      "[[advice]]",
      "Asks `femsph advise`, makes the advised run, and compares it with the prediction (not with --quick).",
      {quantity_key(),
       {"error", key_holds::number, "Percent. Either this or \"within\"."},
       {"within", key_holds::quantity(dimension::time), "The least error in this CPU time."},
       {"budget", key_holds::quantity(dimension::time),
        "CPU time for all ladders together. \"30 s\" unless given."},
       {"methods", key_holds::texts, "The methods to choose from. Those of `femsph advise` unless given."}}};
}

namespace {

void one_price(Fields& fields, StudyReading& reading) {
  const Study& study = reading.study;
  PriceSpec price;
  price.name = read_name(fields, study);
  price.title = fields.text("title", Need::optional).value_or(price.name);
  const QuantitySpec* quantity = read_quantity(fields, reading);
  if (quantity) price.quantity = quantity->name;
  price.reference = fields.choice("reference", Need::optional, price_references).value_or(price.reference);
  if (const auto errors = fields.numbers("errors", Need::optional)) {
    price.errors = *errors;
    if (errors->empty() || std::any_of(errors->begin(), errors->end(), [](double e) { return e <= 0; }))
      fields.fault(
          "errors", "\"errors\" must hold numbers above 0; expected percents, such as [10, 5, 1, 0.1]");
  }
  price.spacing = fields.quantity("spacing", Need::optional, dimension::length, Sign::positive);
  price.base = read_base(fields, reading);
  fields.done();
  if (quantity && !quantity->scene && study.scenes.size() > 1)
    fields.fault(
        "quantity", fmt::format("{} is a quantity of several scenes; expected one that names its scene",
                                in_quotes(price.quantity)));
  else if (quantity && price.reference == Reference::theory && !quantity->theory)
    fields.fault("reference",
                 fmt::format("{} has no theory; expected reference = \"limit\"", in_quotes(price.quantity)));
  reading.study.prices.push_back(price);
}

void one_advice(Fields& fields, StudyReading& reading) {
  const Study& study = reading.study;
  AdviceSpec advice;
  const QuantitySpec* quantity = read_quantity(fields, reading);
  if (quantity) advice.quantity = quantity->name;
  advice.error = fields.number("error", Need::optional, "percent above 0");
  advice.within = fields.quantity("within", Need::optional, dimension::time, Sign::positive);
  advice.budget =
      fields.quantity("budget", Need::optional, dimension::time, Sign::positive).value_or(advice.budget);
  if (quantity && quantity->scene)
    advice.scene = *quantity->scene;
  else if (quantity && !study.scenes.empty())  // empty: reported where the scene is named
    advice.scene = study.scenes.begin()->first;
  const auto scene = study.scenes.find(advice.scene);
  advice.methods = read_methods(
      fields, Need::optional, scene == study.scenes.end() ? nullptr : &scene->second);
  fields.done();
  if (fields.has("error") == fields.has("within") && !fields.misspelt({"error", "within"}))
    fields.fault(
        "error", "expected either \"error\", in percent, or \"within\", a time, in " + fields.name());
  if (advice.error && *advice.error <= 0) fields.fault("error", "\"error\" is not above 0; expected percent");
  if (quantity && (quantity->reduce == Reduce::l2 || (!quantity->scene && study.scenes.size() > 1)))
    fields.fault(
        "quantity",
        fmt::format("{} has no limit of one scene; expected a quantity that names its scene, other than l2",
                    in_quotes(advice.quantity)));
  reading.study.advice.push_back(advice);
}

}  // namespace

void read_advice(Fields& root, StudyReading& reading) {
  for (Fields& fields : root.tables("advice")) one_advice(fields, reading);
}

void read_prices(Fields& root, StudyReading& reading) {
  for (Fields& fields : root.tables("price")) one_price(fields, reading);
}

}  // namespace femsph::compare
