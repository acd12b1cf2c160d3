#include "model/input/lookup.hpp"

#include <algorithm>

#include "model/input/faults.hpp"

namespace femsph {
namespace {

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

std::optional<std::string> nearest_name(std::string_view word, const std::vector<std::string>& names) {
  constexpr std::size_t longest = 60, most = 1000;  // limit the cost for arbitrary input
  if (word.size() > longest || names.size() > most) return {};
  const std::string* best = nullptr;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& name : names) {
    if (name.size() > 2 * longest) continue;
    const std::size_t distance = edit_distance(word, name);
    if (distance < least && distance < name.size()) least = distance, best = &name;
  }
  return best ? std::optional(*best) : std::nullopt;
}

std::string expected_names(std::string_view word, const std::vector<std::string>& names) {
  return "; expected " + one_of(names) + did_you_mean(word, names);
}

}  // namespace femsph
