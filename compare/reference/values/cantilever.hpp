#pragma once
// A cantilever under a force across its end: Euler-Bernoulli and Timoshenko beams.

namespace femsph::compare {

/// beta_n L of a clamped-free beam: the n-th root of cos b cosh b = -1, 1.875104 for n = 1.
double cantilever_eigenvalue(int n);

}  // namespace femsph::compare
