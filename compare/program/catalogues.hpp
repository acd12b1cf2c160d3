#pragma once
// All words that a user can choose from, kind by kind, for `femsph list` and for the tables in READMEs.

#include <string>
#include <vector>

#include "model/input/keys.hpp"

namespace femsph::compare {

struct Catalogue {
  std::string kind;   ///< "theory-values": its marker in READMEs, <!-- femsph:theory-values -->
  std::string title;  ///< "theory values (theory = ..)"
  std::vector<Entry> entries;
};

std::vector<Catalogue> catalogues();
/// A Markdown table of the words and their descriptions.
std::string to_markdown(const Catalogue& catalogue);
/// A README with the tables of all catalogues that it has markers for.
std::string with_catalogues(const std::string& readme);

}  // namespace femsph::compare
