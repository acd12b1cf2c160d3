#pragma once
// The tables inside a README.md, which a command writes.

#include <string>

namespace femsph::compare {

/// `readme` with what lies between the lines <!-- femsph:table --> and <!-- /femsph:table --> replaced by
/// `table`. Throws std::runtime_error when it does not hold the two once each, in this order.
std::string with_table(const std::string& readme, const std::string& table);

}  // namespace femsph::compare
