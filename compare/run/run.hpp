#pragma once
// One run: from a scene, the method of each body and a resolution to histories, profiles, energies and its
// cost.

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "compare/run/plan/body_methods.hpp"
#include "compare/run/plan/run_result.hpp"
#include "fem/fem.hpp"
#include "model/results/checkpoint.hpp"
#include "model/results/history.hpp"
#include "model/results/recorder.hpp"
#include "sph/sph.hpp"

namespace femsph::compare {

/// When a run writes DIR/checkpoint.h5: when it is interrupted, and at these intervals.
struct CheckpointOptions {
  long every_steps = 0;                    ///< 0: not by steps
  double every_seconds = 0;                ///< of the wall clock; 0: not by time
  std::vector<std::string> arguments;      ///< of the command line, for resume
  std::shared_ptr<const Checkpoint> from;  ///< continue from this one
};

/// The spacing of particles in a shape. Throws Refusal when divisions give several.
double spacing_of(const Shape& shape, const Resolution& resolution);

struct RunOptions {
  MarchOptions march;
  std::optional<std::string> folder;            ///< write histories, fields and the record there
  bool fields = true;                           ///< with a folder: fields too
  std::optional<CheckpointOptions> checkpoint;  ///< with a folder
  std::string label;                            ///< of the progress line
  std::string command;                          ///< for the record
  std::set<std::string> scalars =
      {};  ///< which of RunResult::scalars to compute, as some take extra work in every sample
  std::function<void(const std::string&)> warn =
      {};                        ///< called with each warning: before the first step, or once it is known
  RunResult* partial = nullptr;  ///< where a run that stops with a MotionError leaves its results so far
};

/// Throws InputError, MotionError, Interrupted (compare/run/interruption.hpp) or std::runtime_error.
RunResult run_scene(const Scene& scene, const BodyMethods& methods, const Resolution& resolution,
                    const RunOptions& options);

/// What a run derives from its scene, as text: the method of each body if they were given by body, particles
/// or elements, step, memory, effects.
std::vector<std::pair<std::string, std::string>> derived_values(const March& march,
                                                                const BodyMethods& methods);

/// The warnings of the time march, and one if forces are not in balance.
std::vector<std::string> warnings_of(const March& march, const Recorder& recorder);

/// "settled", "not settled" or "finished".
std::string outcome_of(const March& march);

/// The cost of a run in two lines: CPU and wall time, steps, time for each step and unit ("particle"),
/// memory; and its phases.
std::string price_text(const Price& price, const std::string& unit);

/// The discretization alone (for `check` and the bench).
std::unique_ptr<Discretization> discretize(const Scene& scene, std::size_t body, const BodyMethods& methods,
                                           const Resolution& resolution);

}  // namespace femsph::compare
