#pragma once
// A history to compare with, from another program or another solution: a CSV file beside the study, with the
// header "time [s],NAME [unit]".

#include <string>
#include <vector>

namespace femsph::compare {

struct ReferenceTable {
  std::vector<double> at, value;  ///< s, increasing; SI
};

/// `si` is the SI unit of what it is compared with. Throws std::runtime_error with one sentence, FILE:LINE in
/// front.
ReferenceTable read_reference_table(const std::string& file, const std::string& si);

}  // namespace femsph::compare
