#include "model/input/faults.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace femsph {
namespace {

std::vector<Fault> in_order(std::vector<Fault> faults) {
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  });
  constexpr std::size_t most = 1000;  // more are of no use
  if (faults.size() > most) faults.erase(faults.begin() + most, faults.end());
  return faults;
}

std::string message(const std::string& file, const std::vector<Fault>& faults) {
  std::string all;
  for (const Fault& fault : faults) {
    if (!all.empty()) all += '\n';
    all += fault.line > 0 ? fmt::format("{}:{}:{}: {}", file, fault.line, fault.column, fault.text)
                          : fmt::format("{}: {}", file, fault.text);
  }
  return all;
}

// Damerau-Levenshtein distance in its "optimal string alignment" form, with three rows of the table of
// distances of prefixes. It counts the four kinds of errors that most misspellings consist of (F. J. Damerau,
// Commun. ACM 7 (1964) 171).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

}  // namespace

InputError::InputError(const std::string& file, std::vector<Fault> faults)
    : std::runtime_error(message(file, in_order(faults))), faults_(in_order(std::move(faults))) {}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string out = "\"";
  for (const unsigned char c : text.substr(0, longest))
    out += c < 0x20 || c == 0x7f ? fmt::format("\\x{:02x}", c) : std::string(1, char(c));
  return out + (text.size() > longest ? "...\"" : "\"");
}

std::string one_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 40;
  std::string all;
  if (names.size() > most) {
    for (std::size_t i = 0; i < most; ++i) all += in_quotes(names[i]) + ", ";
    return fmt::format("{}.. (one of {})", all, names.size());
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    all += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + in_quotes(names[i]);
  return all;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  constexpr std::size_t longest = 60, most = 1000;  // limit the cost for arbitrary input
  if (word.size() > longest || names.size() > most) return "";
  const std::string* best = nullptr;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& name : names) {
    if (name.size() > 2 * longest) continue;
    const std::size_t distance = edit_distance(word, name);
    if (distance < least && distance < name.size()) least = distance, best = &name;
  }
  return best ? fmt::format("; did you mean {}?", in_quotes(*best)) : "";
}

}  // namespace femsph
