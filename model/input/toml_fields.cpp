// Fields: its tables, and the keys that they may hold. The values of keys: toml_values.cpp.

#include "model/input/toml_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "model/input/lookup.hpp"

namespace femsph {
namespace {

std::string type_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
    case toml::node_type::floating_point:
      return "a plain number";
    case toml::node_type::boolean:
      return "true or false";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::table:
      return "a table";
    default:
      return "a date or time";
  }
}

}  // namespace

Source source_of(const toml::node& node) {
  return {int(node.source().begin.line), int(node.source().begin.column)};
}

Fields::Fields(const toml::table& table, std::string name, Faults& faults)
    : table_(&table), name_(std::move(name)), faults_(&faults) {}

Fields::Fields(const toml::table& table, Faults& faults, const KeyPage& page)
    : table_(&table), faults_(&faults), page_(&page), keys_(&page.at("")) {}

Fields::Fields(const toml::table& table, std::string name, const Fields& parent, const std::string& path)
    : table_(&table),
      name_(std::move(name)),
      faults_(parent.faults_),
      page_(parent.page_),
      path_(path),
      keys_(parent.page_ ? &parent.page_->at(path) : nullptr) {}

void Fields::require_stated(const std::string& key, Need need, const std::vector<std::string>& held) const {
  if (!keys_) return;
  const auto fits = [&](const Key* stated) {
    const bool need_fits = stated->required ? need == Need::required
                                            : need == Need::optional || !stated->when.empty();
    return need_fits && std::all_of(held.begin(), held.end(), [&](const std::string& part) {
             return stated->holds.find(part) != std::string::npos;
           });
  };
  const auto stated = keys_->named(key);
  if (std::any_of(stated.begin(), stated.end(), fits)) return;
  std::string what;
  for (const std::string& part : held) what += (what.empty() ? "" : ", ") + part;
  throw std::logic_error(fmt::format(
      "{} reads the {} key \"{}\" ({}), which its table of keys does not state so",
      name_.empty() ? "the top level" : name_, need == Need::required ? "required" : "optional", key, what));
}

Source Fields::source() const { return source_of(*table_); }

Source Fields::source(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node ? source_of(*node) : source();
}

std::vector<std::string> Fields::stated_keys() const {
  std::vector<std::string> all;
  if (!keys_) return all;
  for (const Key& key : keys_->keys) all.push_back(key.name);
  for (const Entry& entry : keys_->entries)
    for (const Key& key : entry.keys) all.push_back(key.name);
  const std::string below = path_.empty() ? "" : path_ + ".";
  for (const KeyTable& table : page_->tables)
    if (const std::string path = table.path(); path.size() > below.size() && path.starts_with(below))
      all.push_back(path.substr(below.size(), path.find('.', below.size()) - below.size()));
  return all;
}

bool Fields::misspelt(std::initializer_list<std::string_view> keys) const {
  constexpr std::size_t most = 1000;  // limits the cost for arbitrary input
  if (table_->size() > most) return false;
  const std::vector<std::string> stated = stated_keys();
  for (const auto& [given, value] : *table_) {
    if (std::find(stated.begin(), stated.end(), given.str()) != stated.end()) continue;
    const auto meant = nearest_name(given.str(), stated);
    if (meant && !has(*meant) && std::find(keys.begin(), keys.end(), *meant) != keys.end()) return true;
  }
  return false;
}

std::optional<std::size_t> Fields::position_of(const std::string& name, const std::vector<std::string>& known,
                                               const char* key, const std::string& what) const {
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return found - known.begin();
  fault(key, fmt::format("unknown {} {}{}", what, in_quotes(name), expected_names(name, known)));
  return {};
}

void Fields::require_table(const std::string& key, Need need) const {
  if (page_ && page_->at(path_of(key)).required && need != Need::required)
    throw std::logic_error(
        fmt::format("[{}] is read as optional, and its table of keys states it as required", path_of(key)));
}

const toml::node* Fields::find(const char* key, Need need, const std::string& expected,
                               const std::vector<std::string>& held) {
  if (!held.empty()) require_stated(key, need, held);
  asked_.emplace_back(key);
  const toml::node* node = table_->get(key);
  if (!node && need == Need::required && !blind_ && !misspelt({key}))
    faults_->add(source(), fmt::format("missing \"{}\"{}; expected {}", key,
                                       name_.empty() ? "" : " in " + name_, expected));
  return node;
}

void Fields::wrong_type(const toml::node& node, const std::string& key, const std::string& expected) {
  faults_->add(source_of(node), fmt::format("\"{}\" is {}; expected {}", key, type_of(node), expected));
}

const toml::array* Fields::array(const char* key, Need need, const std::string& expected,
                                 const std::vector<std::string>& held) {
  const toml::node* node = find(key, need, expected, held);
  if (node && !node->is_array()) wrong_type(*node, key, expected);
  return node ? node->as_array() : nullptr;
}

std::optional<Fields> Fields::table(const char* key, Need need, const std::string& expected) {
  require_table(key, need);
  const toml::node* node = find(key, need, expected, {});
  if (!node) return {};
  if (!node->is_table()) return wrong_type(*node, key, expected), std::nullopt;
  return Fields(*node->as_table(), fmt::format("[{}]", key), *this, path_of(key));
}

std::vector<Fields> Fields::tables(const char* key) {
  const std::string expected = fmt::format("tables that start with [[{}]]", key);
  require_table(key, Need::optional);
  const toml::array* list = array(key, Need::optional, expected, {});
  std::vector<Fields> all;
  if (!list) return all;
  for (const toml::node& node : *list) {
    if (node.is_table())
      all.push_back(Fields(*node.as_table(), fmt::format("[[{}]]", key), *this, path_of(key)));
    else
      wrong_type(node, key, expected);
  }
  return all;
}

std::vector<std::pair<std::string, Fields>> Fields::named_tables(const char* key, Need need,
                                                                 const std::string& expected) {
  std::vector<std::pair<std::string, Fields>> all;
  const std::string path = fmt::format("{}.NAME", key);
  require_table(path, need);
  const toml::node* node = find(key, need, expected, {});
  if (!node) return all;
  if (!node->is_table()) return wrong_type(*node, key, expected), all;
  if (node->as_table()->empty() && need == Need::required)
    fault(key, fmt::format("\"{}\" is empty; expected {}", key, expected));
  for (const auto& [name, value] : *node->as_table()) {
    const std::string full = fmt::format("{}.{}", key, name.str());
    static const toml::table nothing;
    const toml::table* table = value.as_table();
    if (!table) wrong_type(value, full, expected);
    Fields fields(table ? *table : nothing, fmt::format("[{}]", full), *this, path_of(path));
    fields.blind_ = !table;
    all.emplace_back(std::string(name.str()), std::move(fields));
  }
  const auto place = [](const auto& entry) {
    return std::pair(entry.second.source().line, entry.second.source().column);
  };
  std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
  return all;
}

void Fields::accept_rest() {
  std::vector<std::string> all = stated_keys();
  if (!keys_)
    for (const auto& [key, value] : *table_) all.emplace_back(key.str());
  for (std::string& key : all)
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(std::move(key));
}

void Fields::done() {
  for (const auto& [key, value] : *table_) {
    const std::string word(key.str());
    if (std::find(asked_.begin(), asked_.end(), word) != asked_.end()) continue;
    faults_->add({int(key.source().begin.line), int(key.source().begin.column)},
                 fmt::format("unknown key {}{}{}", in_quotes(word), name_.empty() ? "" : " in " + name_,
                             expected_names(word, asked_)));
  }
}

}  // namespace femsph
