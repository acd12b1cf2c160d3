#pragma once
// Looks up a word that a user wrote in a list of known words.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace femsph {

/// The name that is most similar to `word`. Nothing if none is similar, that is, if more than a third of its
/// letters (and more than one) are inserted, removed, replaced or swapped with a neighbour.
std::optional<std::string> nearest_name(std::string_view word, const std::vector<std::string>& names);

/// "; expected "a", "b" or "c"; did you mean "b"?": the end of a message about a word that is not in `names`.
std::string expected_names(std::string_view word, const std::vector<std::string>& names);

/// The entry of `list` whose word is `name`. `word_of` gives the word of an entry: a member or a function;
/// for a list of plain texts std::identity{}. If there is none, throws an Error with the text `what`, the
/// words of the list and "did you mean".
template <class Error, class List, class WordOf>
const auto& entry_named(const List& list, const std::string& name, WordOf word_of, const std::string& what) {
  std::vector<std::string> words;
  for (const auto& entry : list) {
    if (std::invoke(word_of, entry) == name) return entry;
    words.emplace_back(std::invoke(word_of, entry));
  }
  throw Error(what + expected_names(name, words));
}

/// The value of `choices`, a list of words with their values, that `name` chooses; otherwise as entry_named.
template <class Error, class Choices>
const auto& value_named(const Choices& choices, const std::string& name, const std::string& what) {
  return entry_named<Error>(
             choices, name, [](const auto& choice) { return choice.first; }, what)
      .second;
}

}  // namespace femsph
