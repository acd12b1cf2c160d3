#pragma once
// What the keys of a table mean, said beside the code that reads them. The page of keys (femsph help scene,
// femsph help study) is made of these, and Fields refuses to ask for a key that its table does not state.

#include <string>
#include <vector>

namespace femsph {

/// One key of a table.
struct Key {
  std::string name;  ///< "young"
  std::string
      holds;  ///< what stands behind it: "a pressure", "a number", "a text", or the words to choose from
  std::string about;  ///< one line
  bool required = false;
};

/// A table of an input file.
struct KeyTable {
  std::string header;  ///< as a user writes it: "[materials.NAME]", "[[loads]]"
  std::string about;   ///< one line
  std::vector<Key> keys;
};

/// What every entry of a catalogue says of itself: a law, shape, effect, quantity, theory value, element, ..
struct Entry {
  std::string word;            ///< what the user writes
  std::string about;           ///< one line
  std::vector<Key> keys = {};  ///< that it adds to its table
};

}  // namespace femsph
