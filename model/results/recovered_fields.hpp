#pragma once
// Recovered stress and strain at all points of a body (recovery.hpp), from the means of cells or particles
// near each point. The weights are computed once.

#include <cstdint>
#include <vector>

#include "model/results/cell_means.hpp"

namespace femsph {

class RecoveredFields {
 public:
  RecoveredFields(const Discretization& d, Plane plane);
  /// The values at the points, from the means of one snapshot.
  void fill(const CellFields& cells);
  const CellFields& values() const { return values_; }

 private:
  void value(std::size_t i, const CellFields& cells);
  double kept_within(std::size_t i, const std::vector<double>& of_units) const;

  struct Near {
    std::uint32_t unit;
    float weight;
  };
  Plane plane_;
  std::vector<std::size_t> begin_;  ///< where the units of each point begin in near_
  std::vector<Near> near_;
  CellFields values_;
};

}  // namespace femsph
