#pragma once
// One run: a scene, a method, a resolution -> histories, profiles, energies and a price.

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "fem/fem.hpp"
#include "model/motion/recorder.hpp"
#include "model/results/checkpoint.hpp"
#include "model/results/history.hpp"
#include "sph/sph.hpp"

namespace femsph::compare {

/// A discretization by its name in tables: fem-full, fem-sri, fem-one-point, fem-assumed-strain, sph-classic-share, sph-classic-full,
/// sph-classic-trapezoid, sph-virtual, sph-weight, sph-corrected.
struct Method {
  std::string name;
  std::variant<fem::Options, sph::Options> options;
  std::string about = {};  ///< one line for `femsph list`
  bool is_fem() const { return options.index() == 0; }
};

/// All methods, in the order of tables.
const std::vector<Method>& methods();
/// Throws std::runtime_error with "did you mean".
Method method_named(const std::string& name);

/// How fine: a spacing (FEM: the edge of a square cell; the divisions are the sides' lengths over it, rounded), or divisions along each axis,
/// which for SPH must mean one spacing.
struct Resolution {
  double spacing = 0;  ///< m
  std::array<int, 3> divisions{0, 0, 0};
};

/// When a run writes DIR/checkpoint.h5: always when it is interrupted, and every so often if asked.
struct CheckpointOptions {
  long every_steps = 0;      ///< 0: not by steps
  double every_seconds = 0;  ///< of the wall clock; 0: not by time
  std::vector<std::string> arguments;      ///< of the command line, for resume
  std::shared_ptr<const Checkpoint> from;  ///< take this one up
};

/// The spacing of particles in a shape. Throws Refusal when divisions give several.
double spacing_of(const Shape& shape, const Resolution& resolution);

struct RunResult;

struct RunOptions {
  MarchOptions march;
  std::optional<std::string> folder;  ///< write histories, fields and the record there
  bool fields = true;                 ///< with a folder: fields too
  std::optional<CheckpointOptions> checkpoint;  ///< with a folder
  std::string label;                  ///< of the progress line
  std::string command;                ///< for the record
  std::set<std::string> scalars = {}; ///< which of RunResult::scalars to fill: each costs a look at the run that others do not pay
  std::function<void(const std::string&)> warn = {};  ///< called with each warning: before the first step, or once it is known
  RunResult* partial = nullptr; ///< where a run that stops with a MotionError leaves what it has until then
};

struct RunResult {
  History history;                          ///< time; probes as NAME_x, NAME_y, (NAME_xx, ..); kinetic, strain, .. energies
  std::map<std::string, Profile> profiles;  ///< sections at the last sample
  Ledger ledger;
  double momentum_error = 0;                ///< |sum of internal forces| / sum of |internal forces| at the end
  double moment_error = 0;                  ///< the same of their moments
  Balance balance;                          ///< the worst of all samples
  Price price;
  bool settled = false;
  double spacing = 0;                       ///< m, as discretized; of several bodies the widest
  int cells_over_height = 0;                ///< cells, or particles less one, along y; of bodies with that spacing the fewest
  std::size_t points = 0;                   ///< nodes or particles
  std::map<std::string, double> scalars;    ///< numbers that belong to the whole run, SI, by their names in run_scalars()
  std::vector<std::pair<std::string, std::string>> derived;  ///< see derived_values
  std::vector<std::string> warnings;        ///< of the march
};

/// The scalars a run can give, with their SI units.
const std::vector<std::pair<std::string, std::string>>& run_scalars();

/// Throws InputError, MotionError, Interrupted (compare/interruption.hpp) or std::runtime_error.
RunResult run_scene(const Scene& scene, const Method& method, const Resolution& resolution, const RunOptions& options);

/// What a run derives from its scene, for people: particles or elements, step, memory, effects.
std::vector<std::pair<std::string, std::string>> derived_values(const March& march);

/// Those of the march, and whether its forces have added up.
std::vector<std::string> warnings_of(const March& march, const Recorder& recorder);

/// "settled", "not settled" or "finished".
std::string outcome_of(const March& march);

/// What a run has cost, for people, in two lines: CPU and wall time, steps, time a step and unit ("particle"), memory; and its phases.
std::string price_text(const Price& price, const std::string& unit);

/// The discretization alone (for `check` and the bench).
std::unique_ptr<Discretization> discretize(const Scene& scene, std::size_t body, const Method& method, const Resolution& resolution);

}  // namespace femsph::compare
