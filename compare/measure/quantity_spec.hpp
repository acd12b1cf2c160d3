#pragma once
// A number to take from a run, and what it is compared with.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compare/reference/reference_table.hpp"
#include "compare/run/plan/planned_run.hpp"
#include "model/input/units.hpp"

namespace femsph::compare {

/// A column of the results: a component of a probe or of a section, or an energy.
struct Observed {
  std::string probe, section, column, scalar;  ///< exactly one of them is named
  std::string component;
  Unit unit;
  std::string si = {};  ///< SI unit that a column is expected in; empty: any
};

/// How a history or a profile is reduced to a number: the catalogue is in reductions.hpp.
enum class Reduce {
  final,
  max,
  min,
  peak,
  mean,
  frequency,
  period,
  integral,
  duration,
  fibre_upper,
  fibre_lower,
  l2,
  moment,
  excess
};
enum class SignRule { as_is, reversed, magnitude };

/// A number to take from every run.
struct QuantitySpec {
  std::string name;
  Observed observed;
  Reduce reduce = Reduce::final;
  Observed along;                               ///< excess: the equivalent plastic strain p
  std::optional<std::array<double, 2>> window;  ///< s: the part of a history that `reduce` looks at
  SignRule sign = SignRule::as_is;              ///< how value, theory and limit are shown
  double offset = 0;  ///< added to the value, in the unit and sign of the table: the initial length, for
                      ///< example, to a displacement
  std::optional<std::string> theory;    ///< name of a theory value
  std::optional<double> reference;      ///< instead of theory: a number, in the unit and sign of the table
  std::optional<ReferenceTable> table;  ///< instead of theory, with l2: a whole history
  std::optional<std::string> scene;     ///< only of runs of that scene
  std::vector<std::string> methods;     ///< only of runs with these labels; empty: all
  bool is_of(const PlannedRun& run) const;
};

}  // namespace femsph::compare
