#pragma once
// Numbers that a run has left, against the right ones.

#include <string>

#include "case.hpp"

namespace femsph::field {

/// All of a file. Throws std::runtime_error if the run has left none.
std::string file_text(const std::string& file);

/// What is read, as the table of checks shows it.
std::string name_of(const Read& read);
/// A number and its unit, five digits.
std::string shown(double number, const std::string& unit);

/// Reads from the tables in `folder`, or from what the program `printed`, and judges in the unit in which the
/// right value is given: fills right, found and verdict. Throws std::runtime_error if there is no such
/// number.
void compare_read(const Read& read, const std::string& folder, const std::string& printed, Finding& finding);

}  // namespace femsph::field
