#pragma once

#include <span>
#include <vector>

#include "model/numerics/tensor.hpp"
#include "model/numerics/weight.hpp"

namespace femsph {

/// Weights of scattered points for the value of a field at p: a weighted least-squares fit of a linear field
/// to the points within `radius` (grown until there are enough), so linear fields are reproduced exactly
/// (Lancaster & Salkauskas 1981). A point within `coincident` of p is taken alone.
std::vector<Weight> least_squares_weights(std::span<const Point> points, int dim, const Point& p,
                                          double radius, double coincident);

}  // namespace femsph
