// [[price]] of a study: of which quantity the price of accuracy is to be told.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "compare/study/reader/study_page.hpp"
#include "compare/study/reader/study_reading.hpp"
#include "model/input/units.hpp"

namespace femsph::compare {
namespace {

const std::vector<std::pair<std::string, Reference>> price_references = {
    {"theory", Reference::theory}, {"limit", Reference::limit}};

std::string read_name(Fields& fields, const Study& study) {
  const std::string expected = "a name of letters, digits, _ and -, which files take too";
  const std::string name = fields.text("name", Need::required, expected).value_or("x");
  const auto allowed = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) || c == '_' || c == '-'); };
  if (name.empty() || !std::all_of(name.begin(), name.end(), allowed))
    fields.fault("name", fmt::format("\"name\" is {}; expected {}", in_quotes(name), expected));
  if (std::any_of(
          study.prices.begin(), study.prices.end(), [&](const PriceSpec& p) { return p.name == name; }))
    fields.fault("name", fmt::format("two prices are called {}; expected a name for each", in_quotes(name)));
  return name;
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
      "What accuracy costs by each method: rules in studies/cost/README.md.",
      {{"name", key_holds::text, "In price.csv and in names of files: letters, digits, _ and -.", true},
       {"title", key_holds::text, "For people. The name unless given."},
       {"quantity", "a text: a quantity of this study, of one scene", "Whose error.", true},
       {"reference", key_holds::words(price_references), "Error against what. \"limit\" unless given."},
       {"errors", key_holds::numbers, "Percents above 0. [10, 5, 1, 0.1] unless given."},
       {"spacing", key_holds::quantity(dimension::length), "All methods side by side at this spacing too."},
       {"base", "a text: the name of a method in tables",
        "How many times finer, and dearer, must the others be for its error?"}}};
}

KeyTable advice_keys() {
  return {"[[advice]]",
          "Asks `femsph advise`, follows its advice and compares (not in the quick form).",
          {{"quantity", "a text: a quantity of this study, of one scene", "Whose error.", true},
           {"error", key_holds::number, "Percent. Either this or \"within\"."},
           {"within", key_holds::quantity(dimension::time), "The least error in this CPU time."},
           {"budget", key_holds::quantity(dimension::time),
            "CPU time for all ladders together. \"30 s\" unless given."},
           {"methods", key_holds::texts, "Among which methods. Those of `femsph advise` unless given."}}};
}

namespace {

void one_price(Fields& fields, StudyReading& reading) {
  const Study& study = reading.study;
  PriceSpec price;
  price.name = read_name(fields, study);
  price.title = fields.text("title", Need::optional).value_or(price.name);
  price.quantity = fields.text("quantity", Need::required, one_of(quantity_names(study))).value_or("");
  price.reference = fields.choice("reference", Need::optional, price_references).value_or(price.reference);
  if (const auto errors = fields.numbers("errors", Need::optional)) {
    price.errors = *errors;
    if (errors->empty() || std::any_of(errors->begin(), errors->end(), [](double e) { return e <= 0; }))
      fields.fault(
          "errors", "\"errors\" holds no number above 0; expected percents, such as [10, 5, 1, 0.1]");
  }
  price.spacing = fields.quantity("spacing", Need::optional, dimension::length, Sign::positive);
  price.base = read_base(fields, reading);
  fields.done();
  const auto quantity = std::find_if(study.quantities.begin(), study.quantities.end(),
                                     [&](const QuantitySpec& q) { return q.name == price.quantity; });
  if (quantity == study.quantities.end()) {
    require_known(
        fields, "quantity", "quantity", price.quantity, quantity_names(study), reading.quantities_known);
  } else if (!quantity->scene && study.scenes.size() > 1) {
    fields.fault(
        "quantity", fmt::format("{} is a quantity of several scenes; expected one that names its scene",
                                in_quotes(price.quantity)));
  } else if (price.reference == Reference::theory && !quantity->theory) {
    fields.fault("reference",
                 fmt::format("{} has no theory; expected reference = \"limit\"", in_quotes(price.quantity)));
  }
  reading.study.prices.push_back(price);
}

void one_advice(Fields& fields, StudyReading& reading) {
  const Study& study = reading.study;
  AdviceSpec advice;
  advice.quantity = fields.text("quantity", Need::required, one_of(quantity_names(study))).value_or("");
  advice.error = fields.number("error", Need::optional, "percent above 0");
  advice.within = fields.quantity("within", Need::optional, dimension::time, Sign::positive);
  advice.budget =
      fields.quantity("budget", Need::optional, dimension::time, Sign::positive).value_or(advice.budget);
  advice.methods = read_methods(fields, Need::optional);
  fields.done();
  if (fields.has("error") == fields.has("within"))
    fields.fault(
        "error", "expected either \"error\", in percent, or \"within\", a time, in " + fields.name());
  if (advice.error && *advice.error <= 0) fields.fault("error", "\"error\" is not above 0; expected percent");
  const auto quantity = std::find_if(study.quantities.begin(), study.quantities.end(),
                                     [&](const QuantitySpec& q) { return q.name == advice.quantity; });
  if (quantity == study.quantities.end())
    require_known(
        fields, "quantity", "quantity", advice.quantity, quantity_names(study), reading.quantities_known);
  else if (quantity->reduce == Reduce::l2 || (!quantity->scene && study.scenes.size() > 1))
    fields.fault(
        "quantity",
        fmt::format("{} has no limit of one scene; expected a quantity that names its scene, other than l2",
                    in_quotes(advice.quantity)));
  else if (quantity->scene)
    advice.scene = *quantity->scene;
  else if (!study.scenes.empty())  // none could be read: said where it is named
    advice.scene = study.scenes.begin()->first;
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
