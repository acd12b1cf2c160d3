#pragma once
// A history that another program or another solution has given, as a table beside the study: "time [s],NAME [unit]" above, numbers below.

#include <string>
#include <vector>

namespace femsph::compare {

struct ReferenceTable {
  std::vector<double> at, value;  ///< s, rising; SI
};

/// `si` is the unit of what it is compared with. Throws std::runtime_error with one sentence.
ReferenceTable read_reference_table(const std::string& file, const std::string& si);

/// Distance (L2 over time, percent of the reference) of a history from the table, over the times that both have. Throws std::runtime_error.
double percent_from(const ReferenceTable& table, const std::vector<double>& at, const std::vector<double>& value);

}  // namespace femsph::compare
