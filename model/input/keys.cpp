#include "model/input/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "model/input/faults.hpp"

namespace femsph {
namespace {

constexpr std::size_t columns = 110;

/// `text` wrapped to at most `columns`; all lines but the first are indented.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::string out, line;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!line.empty() && line.size() + 1 + word.size() > columns) {
      out += line + "\n";
      line = std::string(indent, ' ') + word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
    begin = end + 1;
  }
  return out + line + "\n";
}

std::string item(const Key& key) {
  const std::string need = key.required        ? " (required)"
                           : !key.when.empty() ? fmt::format(" (required {})", key.when)
                                               : "";
  return wrapped(fmt::format("- `{}`{}: {}. {}", key.name, need, key.holds, key.about), 2);
}

std::string one_table(const KeyTable& table) {
  std::string out = table.header.empty() ? "## At the top of the file\n"
                                         : fmt::format("## {}\n", table.header);
  out += wrapped(table.about + (table.required ? " Required." : ""), 0) + "\n";
  for (const Key& key : table.keys) out += item(key);
  for (const Entry& entry : table.entries) {
    out += "\n" + wrapped(fmt::format("`{} = \"{}\"`: {}", table.chooses, entry.word, entry.about), 0);
    if (!entry.keys.empty()) out += "\n";
    for (const Key& key : entry.keys) out += item(key);
  }
  return out;
}

}  // namespace

std::string KeyTable::path() const {
  const auto begin = header.find_first_not_of('['), end = header.find_last_not_of(']');
  return begin == std::string::npos ? "" : header.substr(begin, end - begin + 1);
}

std::vector<const Key*> KeyTable::named(const std::string& key) const {
  std::vector<const Key*> found;
  const auto look = [&](const std::vector<Key>& list) {
    for (const Key& k : list)
      if (k.name == key) found.push_back(&k);
  };
  look(keys);
  for (const Entry& entry : entries) look(entry.keys);
  return found;
}

const KeyTable& KeyPage::at(const std::string& path) const {
  const auto found = std::find_if(
      tables.begin(), tables.end(), [&](const KeyTable& table) { return table.path() == path; });
  if (found != tables.end()) return *found;
  throw std::logic_error(fmt::format("the page \"{}\" has no table of keys for {}", title, path));
}

std::string to_markdown(const KeyPage& page) {
  std::string out = fmt::format("# {}\n\n", page.title) + wrapped(page.about, 0);
  for (const KeyTable& table : page.tables) out += "\n" + one_table(table);
  return out;
}

namespace key_holds {

std::string quantity(const Dimension& dimension) { return dimension.name; }
std::string quantities(const Dimension& dimension) {
  return fmt::format("a list, each entry {}", dimension.name);
}
std::string vector(const Dimension& dimension) {
  return fmt::format("a vector, each component {}", dimension.name);
}
std::string matrix(const Dimension* dimension) {
  return fmt::format("a matrix, each entry {}", dimension ? dimension->name : number);
}
std::string corners(const Dimension& dimension) {
  return fmt::format("two corners, each component {}", dimension.name);
}
std::string words(const std::vector<std::string>& words) { return one_of(words); }
std::string words(const std::vector<Entry>& entries) {
  std::vector<std::string> all;
  for (const Entry& entry : entries) all.push_back(entry.word);
  return one_of(all);
}

}  // namespace key_holds
}  // namespace femsph
