#pragma once
// Stress and strain at the points of a body (nodes, particles) by the rule of recovery.hpp, from the means of
// the units around each: the weights are found once.

#include <cstdint>
#include <vector>

#include "model/results/cell_means.hpp"

namespace femsph {

class RecoveredFields {
 public:
  RecoveredFields(const Discretization& d, Plane plane);
  /// From the cells of one snapshot.
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
  std::vector<std::size_t> begin_;  ///< of each point, in near_
  std::vector<Near> near_;
  CellFields values_;
};

}  // namespace femsph
