#pragma once
// A study: a folder with study.toml, scene files, plot.gp and a README.md. study.toml says which runs to
// make, which numbers to take from them, what to compare these with, and which claims to check; its format is
// described in studies/README.md.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/measure/quantity_spec.hpp"
#include "compare/study/reader/claims.hpp"
#include "compare/study/reader/verdicts.hpp"
#include "model/input/faults.hpp"

namespace femsph::compare {

/// A number that the paper reports.
struct PaperNumber {
  RowFilter rows;
  std::optional<double> value;          ///< in the quantity's unit
  std::optional<double> error_percent;  ///< as the paper states it
  std::string source;
};

/// A data file for figures.
struct SeriesSpec {
  enum class Kind { error, cases, history, profile, path } kind = Kind::error;
  std::string file;
  std::string quantity;                     ///< error, cases
  Reference reference = Reference::theory;  ///< error, cases
  Observed observed;                        ///< history, profile
  Unit time_unit{"ms", 1e-3};               ///< history
  Observed along;                           ///< path: the abscissa
  std::optional<std::string> theory;        ///< history, profile: adds a column of theory
  std::vector<std::string> cases, methods;  ///< empty: all
  std::optional<std::string> scene;         ///< whose theory; default: the first run's
};

/// The converged solution to compare with: the static solution of the elastic body by FEM of high degree; or,
/// with `ladder`, Richardson's extrapolation of the runs of that method, for each quantity.
struct LimitSpec {
  std::array<int, 3> divisions{};
  int degree = 4;
  std::string ladder;  ///< a method's label; empty: the static solution
};

/// The cost of accuracy by each method: one scene and quantity of price.csv.
struct PriceSpec {
  std::string name, title;  ///< name: in tables and names of files; title: heading in price.md
  std::string quantity;     ///< of one scene
  Reference reference = Reference::limit;
  std::vector<double> errors{10, 5, 1, 0.1};  ///< percent
  std::optional<double> spacing;              ///< m: all methods compared at this spacing too
  std::string base;  ///< method that the others are compared with at equal error; empty: none
};

/// A question to `advise`; the run that it advises is made and compared with the prediction.
struct AdviceSpec {
  std::string scene, quantity;
  std::optional<double> error, within;  ///< percent; s
  double budget = 30;                   ///< s
  std::vector<BodyMethods> methods;     ///< empty: those of `femsph advise`
};

struct Study {
  std::string name, title, folder, file;
  std::map<std::string, Scene> scenes;  ///< by their file's name
  std::vector<PlannedRun> runs;
  std::vector<QuantitySpec> quantities;
  std::vector<PaperNumber> paper;
  std::vector<SeriesSpec> series;
  std::optional<LimitSpec> limit;           ///< of every scene that `limits` does not name
  std::map<std::string, LimitSpec> limits;  ///< by scene
  int repeat = 1;                           ///< how often every run is made, for the spread of its time
  std::vector<PriceSpec> prices;
  std::vector<AdviceSpec> advice;
  std::vector<Study> collected;  ///< these are run too, and their rows belong to this study
  std::vector<Claim> claims;
  std::vector<Bound> bounds;  ///< if there are any, the study's table shows verdicts
  std::vector<Expectation> expectations;
};

/// Reads a study and its scenes. Throws InputError with all faults of study.toml.
Study read_study(const std::string& file);
/// The same from memory; scenes are looked for beside `file`.
Study parse_study(const std::string& text, const std::string& file);

}  // namespace femsph::compare
