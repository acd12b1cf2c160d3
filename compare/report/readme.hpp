#pragma once
// The tables inside a README.md, which a command writes.

#include <string>

namespace femsph::compare {

/// `readme` with what lies between the lines <!-- femsph:NAME --> and <!-- /femsph:NAME --> replaced by
/// `table`. Throws std::runtime_error when it does not hold the two once each, in this order.
std::string with_table(const std::string& readme, const std::string& table,
                       const std::string& name = "table");
/// Whether it holds the line <!-- femsph:NAME -->.
bool has_table(const std::string& readme, const std::string& name);

}  // namespace femsph::compare
