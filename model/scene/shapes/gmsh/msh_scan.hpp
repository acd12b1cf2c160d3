#pragma once
// What a .msh file says and the library of Gmsh keeps to itself: all names, how many elements there ought to
// be, and in which group each was listed.

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
  std::size_t elements = 0;  ///< as announced, all kinds
  std::vector<std::size_t>
      numbers;              ///< of the elements in the file's order; not of binary files of version 4
  std::vector<int> groups;  ///< if lists_groups(): the physical group that each is listed in; a cell of two
                            ///< groups is listed twice
  bool lists_groups() const { return version < 3; }
};

/// `corners_of(type)`: the number of nodes of an element type, for binary files. Throws std::runtime_error
/// with one sentence when a section holds more lines than it announces: Gmsh leaves these out. Any bytes will
/// do: whatever is no such file is for Gmsh to refuse.
MshFacts scan_msh(const std::string& file, const std::function<int(int)>& corners_of);

}  // namespace femsph
