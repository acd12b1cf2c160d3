#pragma once
// A history that another program or another solution has given, as a table beside the study: "time [s],NAME
// [unit]" above, numbers below.

#include <string>
#include <vector>

namespace femsph::compare {

struct ReferenceTable {
  std::vector<double> at, value;  ///< s, rising; SI
};

/// `si` is the unit of what it is compared with. Throws std::runtime_error with one sentence.
ReferenceTable read_reference_table(const std::string& file, const std::string& si);

}  // namespace femsph::compare
