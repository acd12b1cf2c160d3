#pragma once
// A study's `options = {..}`: changes to a method's options, by name.

#include "compare/run.hpp"
#include "model/scene/toml_fields.hpp"

namespace femsph::compare {

struct Overrides {
  std::optional<double> smoothing, alpha, beta, gamma, hourglass, jitter, distortion;
  std::optional<sph::KernelKind> kernel;
  std::optional<sph::MassRule> mass;
  std::optional<sph::Boundary> boundary;

  void apply(Method& method) const;
  /// " smoothing=1.2 alpha=5", to tell a changed method from the plain one in tables; empty if nothing is changed.
  std::string describe() const;
};

/// Reads the options that every one of `methods` has; faults for the others, with "did you mean".
Overrides read_overrides(Fields& options, const std::vector<Method>& methods);

}  // namespace femsph::compare
