#pragma once
// What the library of Gmsh does not report of a .msh file: all names, how many elements the file announces,
// and the group in which each element is listed.

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace femsph {

struct MshFacts {
  struct Name {
    int dim, tag;
    std::string text;
  };
  double version = 0;
  std::vector<Name> names;   ///< every line of $PhysicalNames
  std::size_t elements = 0;  ///< of all kinds, as the file announces them
  std::vector<std::size_t>
      numbers;  ///< of the elements, in the order of the file; empty for binary files of version 4
  std::vector<int>
      groups;  ///< if lists_groups(): the physical group of each; an element of two groups is listed twice
  bool lists_groups() const { return version < 3; }
};

/// `corners_of(type)`: the number of nodes of an element type, for binary files. Throws std::runtime_error
/// with one sentence if a section has more lines than it announces, which Gmsh would ignore. The file may
/// have any content; Gmsh refuses what is no .msh file.
MshFacts scan_msh(const std::string& file, const std::function<int(int)>& corners_of);

}  // namespace femsph
