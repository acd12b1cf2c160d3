#pragma once
// The results of a run.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/motion/balance.hpp"
#include "model/results/history.hpp"

namespace femsph::compare {

struct RunResult {
  History history;  ///< time; probes as NAME_x, NAME_y, (NAME_xx, ..); kinetic, strain, .. energies
  std::map<std::string, Profile> profiles;  ///< sections at the last sample
  Ledger ledger;
  double momentum_error = 0;  ///< |sum of internal forces| / sum of |internal forces| at the end
  double moment_error = 0;    ///< the same of their moments
  Balance balance;            ///< the worst of all samples
  Price price;
  bool settled = false;
  double spacing = 0;  ///< m, as discretized; the widest of several bodies
  int cells_over_height =
      0;  ///< cells, or particles less one, along y; the fewest of the bodies with that spacing
  std::size_t points = 0;  ///< nodes or particles
  std::map<std::string, double>
      scalars;  ///< numbers that belong to the whole run, SI, by their names in run_scalars()
  std::vector<std::pair<std::string, std::string>> derived;  ///< see derived_values
  std::vector<std::string> warnings;                         ///< of the march
};

/// The scalars a run can give, with their SI units.
const std::vector<std::pair<std::string, std::string>>& run_scalars();

}  // namespace femsph::compare
