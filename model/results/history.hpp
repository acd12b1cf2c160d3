#pragma once
// Histories: named columns over time.

#include <string>
#include <vector>

namespace femsph {

struct Column {
  std::string name, unit;  ///< "tip_x", "m"
  std::vector<double> values;
};

struct History {
  std::vector<Column> columns;  ///< the first is "time", "s"; all of one length
  /// Returns the new column's index; throws std::logic_error if the name is taken.
  std::size_t add(std::string name, std::string unit);
  /// Throws std::out_of_range with the names that exist.
  const Column& operator[](const std::string& name) const;
  bool has(const std::string& name) const;
  std::size_t rows() const { return columns.empty() ? 0 : columns[0].values.size(); }
};

/// A quantity along a section line at one time.
struct Profile {
  std::string name;
  double time = 0;               ///< s
  std::vector<double> distance;  ///< m from the line's start
  std::vector<Column> columns;   ///< components
};

/// Writes `file` under a temporary name, which is then renamed. CSV: a header "name [unit],..", and 17
/// significant digits. Throws std::runtime_error with the file and the system's reason. The folder must
/// exist.
void write_csv(const History& history, const std::string& file);
/// Columns: distance, those of the profile, and time.
void write_csv(const Profile& profile, const std::string& file);
/// HDF5: one dataset for each column, with an attribute "unit".
void write_hdf5(const History& history, const std::string& file);
/// Writes a text under a temporary name, which is then renamed.
void write_text(const std::string& text, const std::string& file);

}  // namespace femsph
