#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "model/input/toml_fields.hpp"
#include "tests/field/case.hpp"

namespace femsph::field {
namespace {

const std::vector<std::pair<std::string, Reduce>> reductions = {
    {"final", Reduce::final},       {"first", Reduce::first},
    {"max", Reduce::max},           {"min", Reduce::min},
    {"peak", Reduce::peak},         {"mean", Reduce::mean},
    {"middle", Reduce::middle},     {"swing", Reduce::swing},
    {"integral", Reduce::integral}, {"frequency", Reduce::frequency},
    {"stop", Reduce::stop}};

/// "2 mm", or a plain number.
std::optional<Quantity> quantity(Fields& fields, const toml::table& table, const char* key) {
  if (!fields.has(key)) return {};
  if (!table.get(key)->is_string()) {
    const auto number = fields.number(key, Need::required, "a number, or a text with a number and its unit");
    return number ? std::optional(Quantity{*number, "1"}) : std::nullopt;
  }
  const std::string text = *fields.text(key, Need::required);
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  while (*end == ' ') ++end;
  if (end == text.c_str() || *end == 0)
    fields.fault(key, fmt::format("\"{}\" is {}; expected a number and its unit, such as \"2 mm\"", key,
                                  in_quotes(text)));
  return Quantity{number, end};
}

std::vector<std::string> texts(Fields& fields, const char* key) {
  return fields.texts(key, Need::optional, "a list of texts").value_or(std::vector<std::string>{});
}

Read one_read(Fields& fields, const toml::table& table) {
  Read read;
  read.columns = texts(fields, "columns");
  read.table = fields.text("table", Need::optional).value_or("history");
  read.after = fields.text("after", Need::optional).value_or("");
  read.reduce = fields.choice<Reduce>("reduce", Need::optional, reductions).value_or(Reduce::final);
  if (const auto window = fields.numbers("window", Need::optional)) {
    if (window->size() == 2 && (*window)[0] < (*window)[1])
      read.window = {(*window)[0], (*window)[1]};
    else
      fields.fault("window", "\"window\" is no interval; expected two numbers, in s (in m along a section)");
  }
  read.value = quantity(fields, table, "value");
  read.within = quantity(fields, table, "within");
  read.least = quantity(fields, table, "least");
  read.most = quantity(fields, table, "most");
  read.percent = fields.number("percent", Need::optional);
  read.why = fields.text("why", Need::required, "how the value is known, and where the tolerance comes from")
                 .value_or("");
  if (read.columns.empty() == read.after.empty())
    fields.fault("columns", "expected either \"columns\" or \"after\"");
  if (read.value && read.percent.has_value() == read.within.has_value())
    fields.fault("value", "expected one of \"percent\" and \"within\" beside \"value\"");
  if (!read.value && !read.least && !read.most)
    fields.fault("value", "nothing is asserted; expected \"value\", \"least\" or \"most\"");
  fields.done();
  return read;
}

Run one_run(Fields& fields, const toml::table& table, Faults& faults) {
  Run run;
  run.line = fields.source().line;
  run.scenes = texts(fields, "scenes");
  run.methods = texts(fields, "methods");
  run.spacings = texts(fields, "spacings");
  run.options = texts(fields, "options");
  run.command = fields.text("command", Need::optional).value_or("run");
  run.quick = fields.flag("quick", Need::optional).value_or(false);
  run.interrupt = fields.flag("interrupt", Need::optional).value_or(false);
  if (const auto codes = fields.numbers("exit", Need::optional))
    run.exit.assign(codes->begin(), codes->end());
  if (run.exit.empty()) fields.fault("exit", "\"exit\" is empty; expected one exit code or more");
  run.says = texts(fields, "says");
  run.silent = texts(fields, "silent");
  run.gap = fields.text("gap", Need::optional).value_or("");
  const auto words = texts(fields, "replace");
  if (words.size() % 2)
    fields.fault(
        "replace",
        "\"replace\" has an odd number of texts; expected pairs: what stands there, what is put there");
  for (std::size_t i = 0; i + 1 < words.size(); i += 2) run.replace.emplace_back(words[i], words[i + 1]);
  if (run.scenes.empty()) run.scenes = {""};
  if (run.methods.empty()) run.methods = {""};
  if (run.spacings.empty()) run.spacings = {""};
  fields.tables("reads");  // known to `done`; read below, with the tables themselves at hand
  fields.done();
  if (const toml::array* list = table["reads"].as_array())
    for (const toml::node& node : *list)
      if (const toml::table* one = node.as_table()) {
        Fields read(*one, "[[runs.reads]]", faults);
        run.reads.push_back(one_read(read, *one));
      }
  return run;
}

}  // namespace

Row read_row(const std::string& file) {
  const toml::table table = parse_toml(read_text_file(file, "a file of cases (TOML)"), file);
  Faults faults;
  Fields root(table, "", faults);
  Row row;
  row.file = file;
  row.stem = std::filesystem::path(file).stem().string();
  row.number = root.text("row", Need::required).value_or("");
  row.title = root.text("title", Need::required).value_or("");
  row.source = root.text("source", Need::required).value_or("");
  row.wanted = root.text("wanted", Need::required).value_or("");
  root.tables("runs");
  root.done();
  if (const toml::array* list = table["runs"].as_array())
    for (const toml::node& node : *list)
      if (const toml::table* one = node.as_table()) {
        Fields run(*one, "[[runs]]", faults);
        row.runs.push_back(one_run(run, *one, faults));
      }
  if (row.runs.empty()) faults.add({}, "nothing is run; expected [[runs]]");
  faults.raise(file);
  return row;
}

}  // namespace femsph::field
