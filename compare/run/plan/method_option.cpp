#include "compare/run/plan/method_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <stdexcept>

namespace femsph::compare {
namespace {

std::optional<OptionValue> read_option(Fields& options, const MethodOption& option) {
  const char* key = option.word.c_str();
  if (!option.words.empty()) {
    std::vector<std::pair<std::string, std::string>> choices;
    for (const std::string& word : option.words) choices.emplace_back(word, word);
    return options.choice(key, Need::optional, choices);
  }
  if (!option.range) return options.flag(key, Need::optional);
  const auto value = options.number(key, Need::optional);
  if (!value || option.range->holds(*value)) return value;
  options.fault(
      key, fmt::format("\"{}\" is {:g}; expected {}", option.word, *value, option.range->describe()));
  return {};
}

std::string text_of(const OptionValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:g}", *number);
  if (const auto* flag = std::get_if<bool>(&value)) return fmt::format("{}", *flag);
  return std::get<std::string>(value);
}

}  // namespace

std::string OptionRange::describe() const {
  return open ? fmt::format("a number above {:g}, up to {:g}", least, most)
              : fmt::format("a number from {:g} to {:g}", least, most);
}

std::string MethodOption::holds() const {
  return !words.empty() ? key_holds::words(words) : range ? range->describe() : key_holds::flag;
}

const MethodOption& method_option(const std::string& word) {
  for (const MethodOption& option : method_options())
    if (option.word == word) return option;
  throw std::logic_error("no option is called " + word);
}

std::string why_idle(const Method& method, const MethodOption& option) {
  if (method.is_fem() && !option.of_fem) return "it is an option of SPH";
  if (!method.is_fem() && !option.of_sph) return "it is an option of FEM";
  return option.idle(method);
}

std::string why_idle(const BodyMethods& methods, const MethodOption& option) {
  std::vector<std::string> reasons;
  for (const BodyMethod& entry : methods.entries) {
    const std::string why = why_idle(entry.method, option);
    if (why.empty()) return "";
    if (std::find(reasons.begin(), reasons.end(), why) == reasons.end()) reasons.push_back(why);
  }
  return fmt::format("{}", fmt::join(reasons, ", and "));
}

std::string bodies_with(const BodyMethods& methods, const MethodOption& option) {
  std::vector<std::string> with, without;
  bool others = false, all = true;  // others: the bodies that are not named
  for (const BodyMethod& entry : methods.entries) {
    const bool idle = !why_idle(entry.method, option).empty();
    all = all && !idle;
    if (entry.body.empty())
      others = !idle;
    else
      (idle ? without : with).push_back(entry.body);
  }
  if (all) return "";
  return others ? fmt::format("every body but {}", fmt::join(without, ", "))
                : fmt::format("{}", fmt::join(with, ", "));
}

bool Overrides::has(const std::string& word) const {
  return std::any_of(values.begin(), values.end(), [&](const auto& v) { return v.first->word == word; });
}

void Overrides::set(const std::string& word, OptionValue value) {
  const MethodOption& option = method_option(word);
  std::erase_if(values, [&](const auto& v) { return v.first == &option; });
  const auto after = std::find_if(
      values.begin(), values.end(), [&](const auto& v) { return v.first > &option; });
  values.insert(after, {&option, std::move(value)});
}

void Overrides::apply(BodyMethods& methods) const {
  for (BodyMethod& entry : methods.entries) {
    entry.changes = describe(entry.method);
    for (const auto& [option, value] : values)
      if (why_idle(entry.method, *option).empty()) option->set(entry.method, value);
  }
}

std::string Overrides::describe(const Method& method) const {
  std::string text;
  for (const auto& [option, value] : values)
    if (why_idle(method, *option).empty()) text += fmt::format(" {}={}", option->word, text_of(value));
  return text;
}

KeyTable override_keys() {
  KeyTable table{"[runs.options]",
                 "Changes to the methods, inline: options = {smoothing = 1.2}. Each of the methods must have "
                 "the option; with a method for each body, that of at least one body must, and it applies to "
                 "those that do.",
                 {}};
  for (const MethodOption& option : method_options()) {
    std::string about = option.about + ".";
    about[0] = char(std::toupper(static_cast<unsigned char>(about[0])));
    table.keys.push_back({option.word, option.holds(), about});
  }
  return table;
}

Overrides read_overrides(Fields& options, const std::vector<BodyMethods>& methods) {
  const auto any = [&](bool (BodyMethods::*holds)() const) {
    return std::any_of(methods.begin(), methods.end(), std::mem_fn(holds));
  };
  const bool any_fem = any(&BodyMethods::all_fem), any_sph = any(&BodyMethods::all_sph);
  Overrides read;
  std::vector<const MethodOption*> asked;
  for (const MethodOption& option : method_options()) {
    if ((any_fem && !option.of_fem) || (any_sph && !option.of_sph)) continue;
    asked.push_back(&option);
    if (auto value = read_option(options, option)) read.values.emplace_back(&option, std::move(*value));
  }
  options.done();
  for (const MethodOption* option : asked)
    for (const BodyMethods& method : methods)
      if (const std::string why = why_idle(method, *option); !why.empty() && options.has(option->word)) {
        options.fault(
            option->word, fmt::format("\"{}\" does nothing with {}: {}", option->word, method.name, why));
        break;
      }
  return read;
}

}  // namespace femsph::compare
