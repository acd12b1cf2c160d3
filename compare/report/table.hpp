#pragma once
// The table of a study, one row for each run and quantity; and the observed orders of its ladders.

#include <optional>
#include <string>
#include <vector>

namespace femsph::compare {

/// An empty optional is an unknown number, an empty cell. Value, theory, limit and paper are in `unit`;
/// errors are in percent of the reference, positive when the value is larger in magnitude.
struct Row {
  std::string study, case_name, method;
  std::optional<double> spacing_mm, cells_over_height;
  std::string quantity;
  std::optional<double> value;
  std::string unit;
  std::optional<double> theory, error_percent, limit, error_vs_limit_percent, paper, paper_error_percent;
  std::optional<double> steps, dt_s, cpu_s, wall_s, threads, points, ns_per_unit_step,
      energy_imbalance_percent, momentum_error;
  /// Unknowns; memory held; CPU of the whole run with its set-up: median, smallest and largest of `repeats`
  /// runs (cpu_s: median of the time march alone).
  std::optional<double> dof, memory_mb, total_cpu_s, total_cpu_min_s, total_cpu_max_s, repeats;
  std::optional<bool> settled;
  std::string failure;  ///< why there is no value
  std::optional<double> energy_drift, momentum_drift, angular_momentum_drift,
      hourglass_share;  ///< fractions; only of studies with bounds
  int ladder = 0;       ///< number of the ladder (series of spacings) that the row belongs to; not written
  std::string scene;    ///< not written
  std::optional<double> units;                ///< particles or elements; not written
  std::optional<double> limit_known_percent;  ///< how well an extrapolated limit is known; not written
  std::string
      limit_doubt;  ///< why there is no limit to compare with, although the study asks for one; in table.md
};

/// The convergence of one ladder (study, method, quantity) against one reference.
struct Order {
  std::string study, method, quantity, reference;  ///< reference: "theory" or "limit"
  std::vector<double> spacings_mm;                 ///< coarse to fine
  std::vector<double> pairwise;                    ///< observed order of neighbouring rungs
  std::optional<double> observed;                  ///< least squares over the ladder
  std::optional<double> extrapolated;              ///< Richardson's limit of the three finest, in `unit`
  std::string unit;
};

/// What a row is measured against. `value`: nothing, its value counts as the error.
enum class Reference { theory, limit, value };
/// The error of a row against a reference, percent; nothing where it is not a finite number.
std::optional<double> error_of(const Row& row, Reference reference);

/// The ladders among the rows, in their order; rows that did not settle and ladders with fewer than two
/// spacings are left out. A limit is extrapolated where the finest three show an order of convergence
/// (ladder.hpp).
std::vector<Order> orders_of(const std::vector<Row>& rows);

/// RFC 4180, with a header line. A number has ten significant digits; an unknown cell is empty.
std::string csv(const std::vector<Row>& rows);
std::string csv(const std::vector<Order>& orders);
/// One cell by RFC 4180: quoted where it must be.
std::string csv_cell(const std::string& text);
std::string csv_number(double value);
std::string csv_number(const std::optional<double>& value);
/// Cells, quoted where they must be, with the end of the line.
std::string csv_line(const std::vector<std::string>& cells);

/// Rounded, in Markdown: one aligned table for each quantity; then the orders and the failures.
std::string markdown(const std::vector<Row>& rows, const std::vector<Order>& orders);
/// Aligned Markdown; the first line of `cells` is the header. Columns that are empty below it are left out.
std::string markdown_table(const std::vector<std::vector<std::string>>& cells);
/// Rounded to significant digits, without an exponent between 1e-4 and 1e6.
std::string rounded(double value, int digits = 4);

}  // namespace femsph::compare
