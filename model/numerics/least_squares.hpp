#pragma once

#include <span>
#include <vector>

#include "model/numerics/tensor.hpp"
#include "model/numerics/weight.hpp"

namespace femsph {

/// Weights of scattered points for the value of a field at p, by a moving least-squares fit of a linear field
/// to the points within `radius` (Lancaster & Salkauskas, Math. Comput. 37, 1981). Linear fields are
/// reproduced exactly. The radius is increased until the points determine the fit. If a point lies within
/// `coincident` of p, only that point is used.
std::vector<Weight> least_squares_weights(std::span<const Point> points, int dim, const Point& p,
                                          double radius, double coincident);

}  // namespace femsph
