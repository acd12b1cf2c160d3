#include "model/motion/discretization.hpp"

#include <algorithm>

namespace femsph {

void Discretization::damping_matrix(const double*, double* y) const { std::fill_n(y, layout().size, 0.0); }

}  // namespace femsph
