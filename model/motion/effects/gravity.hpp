#pragma once
// The body force of gravity, in one pass over a body's points each: its weight, and what it gains.

#include <span>

#include "model/motion/discretization.hpp"

namespace femsph {

/// f += m g
void add_weight(const Layout& at, std::span<const double> mass, const Point& g, double* f);

/// sum_i m_i v_i . g, W: the power of the weight in motion v. The same to the last bit for any number of
/// threads.
double power_of_weight(const Layout& at, std::span<const double> mass, const Point& g, const double* v);

}  // namespace femsph
