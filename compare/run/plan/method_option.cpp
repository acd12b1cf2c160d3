#include "compare/run/plan/method_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
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

void Overrides::apply(Method& method) const {
  for (const auto& [option, value] : values)
    if (method.is_fem() ? option->of_fem : option->of_sph) option->set(method, value);
}

std::string Overrides::describe() const {
  std::string text;
  for (const auto& [option, value] : values) text += fmt::format(" {}={}", option->word, text_of(value));
  return text;
}

KeyTable override_keys() {
  KeyTable table{"[runs.options]",
                 "Changes to the methods, inline: options = {smoothing = 1.2}. Each of the methods must have "
                 "the option.",
                 {}};
  for (const MethodOption& option : method_options()) {
    std::string about = option.about + ".";
    about[0] = char(std::toupper(static_cast<unsigned char>(about[0])));
    table.keys.push_back({option.word, option.holds(), about});
  }
  return table;
}

Overrides read_overrides(Fields& options, const std::vector<Method>& methods) {
  const auto is_fem = [](const Method& method) { return method.is_fem(); };
  const bool any_fem = std::any_of(methods.begin(), methods.end(), is_fem),
             any_sph = !std::all_of(methods.begin(), methods.end(), is_fem);
  Overrides read;
  std::vector<const MethodOption*> asked;
  for (const MethodOption& option : method_options()) {
    if ((any_fem && !option.of_fem) || (any_sph && !option.of_sph)) continue;
    asked.push_back(&option);
    if (auto value = read_option(options, option)) read.values.emplace_back(&option, std::move(*value));
  }
  options.done();
  for (const MethodOption* option : asked)
    for (const Method& method : methods)
      if (const std::string why = why_idle(method, *option); !why.empty() && options.has(option->word)) {
        options.fault(
            option->word, fmt::format("\"{}\" does nothing with {}: {}", option->word, method.name, why));
        break;
      }
  return read;
}

}  // namespace femsph::compare
