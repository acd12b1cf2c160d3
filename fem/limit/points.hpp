#pragma once
// Points of femsph as points of deal.II, and back.

#include <deal.II/base/point.h>

#include "model/scene/shapes/shape.hpp"

namespace femsph::fem {

template <int dim>
dealii::Point<dim> to_dealii(const Point& p) {
  dealii::Point<dim> r;
  for (int d = 0; d < dim; ++d) r[d] = p[d];
  return r;
}

/// Components beyond dim are 0.
template <int dim>
Point to_point(const dealii::Point<dim>& p) {
  Point r{};
  for (int d = 0; d < dim; ++d) r[d] = p[d];
  return r;
}

}  // namespace femsph::fem
