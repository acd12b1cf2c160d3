#pragma once
// A study's `options = {..}`: changes to a method's options, by name.

#include "compare/run/plan/method.hpp"
#include "model/input/toml_fields.hpp"

namespace femsph::compare {

struct Overrides {
  std::optional<double> smoothing, alpha, beta, gamma, hourglass, jitter, distortion;
  std::optional<sph::KernelKind> kernel;
  std::optional<sph::MassRule> mass;
  std::optional<sph::Boundary> boundary;
  std::optional<sph::KernelVolume> kernel_volume;
  std::optional<sph::Dilatation> dilatation;
  std::optional<bool> projection;

  void apply(Method& method) const;
  /// " smoothing=1.2 alpha=5", to tell a changed method from the plain one in tables; empty if nothing is
  /// changed.
  std::string describe() const;
};

/// A range of an option's numbers, for the command line and for studies alike; `open`: without its lower end.
struct OptionRange {
  const char* name;
  double least, most;
  bool open;
  bool holds(double value) const { return (open ? value > least : value >= least) && value <= most; }
  std::string describe() const;  ///< "a number above 0, up to 10"
};
/// smoothing, alpha, beta, gamma, hourglass, jitter, distortion.
const OptionRange& option_range(const std::string& name);

/// The words of a method's options, for the command line and for studies alike.
template <class T>
using Words = std::vector<std::pair<std::string, T>>;
extern const Words<sph::KernelKind> kernel_words;
extern const Words<sph::MassRule> mass_words;
extern const Words<sph::KernelVolume> kernel_volume_words;
extern const Words<sph::Dilatation> dilatation_words;

/// Why an option (by its name above, or viscosity, kernel, mass, boundary, kernel_volume, dilatation,
/// projection) does nothing with this method: "hourglass control belongs to .."; empty where it does
/// something.
std::string why_idle(const Method& method, const std::string& option);

/// Reads the options that every one of `methods` has; faults for the others, with "did you mean".
Overrides read_overrides(Fields& options, const std::vector<Method>& methods);

}  // namespace femsph::compare
