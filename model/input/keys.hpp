#pragma once
// Descriptions of tables and keys, which stand beside the code that reads them. The pages of keys (femsph
// help scene, femsph help study, docs/) are made from them. Fields refuses to read a key that its table does
// not describe, so that page and reader cannot differ.

#include <string>
#include <vector>

#include "model/input/units.hpp"

namespace femsph {

/// One key of a table.
struct Key {
  std::string name;   ///< "young"
  std::string holds;  ///< its kind of value: contains the text of `key_holds` for the function that reads it
  std::string about;  ///< one line
  bool required = false;
  std::string when = {};  ///< the case in which an optional key is required: "unless \"point\" is given"
};

/// An entry of a catalogue: a law, shape, effect, quantity, theory value, element, ..
struct Entry {
  std::string word;            ///< what the user writes
  std::string about;           ///< one line
  std::vector<Key> keys = {};  ///< the keys that it adds to its table
};

/// A table of an input file.
struct KeyTable {
  std::string header;  ///< as a user writes it: "[materials.NAME]", "[[loads]]"; "" for the file's top level
  std::string about;   ///< one line
  std::vector<Key> keys;
  std::string chooses = {};         ///< the key whose value is the word of one of `entries`
  std::vector<Entry> entries = {};  ///< a catalogue; the keys of its entries belong to this table too
  bool required = false;
  std::string path() const;  ///< "materials.NAME", "loads"
  std::vector<const Key*> named(const std::string& key) const;
};

/// All tables of a kind of file.
struct KeyPage {
  std::string title, about;
  std::vector<KeyTable> tables;
  /// The table of a path. Throws std::logic_error if the page does not have it.
  const KeyTable& at(const std::string& path) const;
};

/// The page as Markdown, at most 110 columns wide.
std::string to_markdown(const KeyPage& page);

/// The texts for Key::holds, one for each kind of value that Fields can read.
namespace key_holds {
inline const std::string text = "a text", texts = "a list of texts", number = "a number",
                         numbers = "a list of numbers", flag = "true or false", count = "a whole number",
                         table = "a table";
std::string quantity(const Dimension& dimension);          ///< "a length"
std::string quantities(const Dimension& dimension);        ///< "a list, each entry a length"
std::string vector(const Dimension& dimension);            ///< "a vector, each component a length"
std::string matrix(const Dimension* dimension);            ///< "a matrix, each entry a rate", or "a number"
std::string corners(const Dimension& dimension);           ///< "two corners, each component a length"
std::string words(const std::vector<std::string>& words);  ///< "x", "y" or "z"
template <class T>
std::string words(const std::vector<std::pair<std::string, T>>& choices) {
  std::vector<std::string> all;
  for (const auto& [word, value] : choices) all.push_back(word);
  return words(all);
}
/// The words of a catalogue.
std::string words(const std::vector<Entry>& entries);
}  // namespace key_holds

}  // namespace femsph
