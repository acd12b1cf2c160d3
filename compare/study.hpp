#pragma once
// A study: a folder with study.toml, scene files, plot.gp and a README.md. It says which runs to make, what to take from them, what
// to compare it with, and which claims to check. The format is described in studies/README.md.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/claims.hpp"
#include "compare/reference_table.hpp"
#include "compare/run.hpp"
#include "compare/verdicts.hpp"
#include "model/scene/faults.hpp"

namespace femsph::compare {

/// One run to make.
struct PlannedRun {
  std::string case_name, label;  ///< label: the method's name in tables
  Method method;                 ///< with the study's overrides
  Resolution resolution;
  std::string scene;  ///< a key of Study::scenes
  MarchOptions march;
  bool quick = false;  ///< part of the quick form
  int ladder = 0;      ///< runs of one [[runs]] table share it
};

/// A unit of the tables: one of it is `factor` SI units.
struct Unit {
  std::string name;
  double factor = 1;
};

/// A column of the results: a component of a probe or of a section, or an energy.
struct Observed {
  std::string probe, section, column, scalar;  ///< exactly one of them is named
  std::string component;
  Unit unit;
  std::string si = {};  ///< of a column: what it is taken to be in; empty: whatever it is
};

/// `integral`: of a force over time; `duration`: from the first to the last sample that is not zero, as a time of contact; `excess`: largest amount by which an equivalent stress lies above its yield curve, yield + H p, over the yield stress; `moment`: of a section's axial stress about its middle, integral sigma_xx (y - y0) dA.
enum class Reduce { final, max, min, peak, mean, frequency, period, integral, duration, fibre_upper, fibre_lower, l2, moment, excess };
enum class SignRule { as_is, reversed, magnitude };

/// A number to take from every run.
struct QuantitySpec {
  std::string name;
  Observed observed;
  Reduce reduce = Reduce::final;
  Observed along;                                ///< excess: the equivalent plastic strain p
  std::optional<std::array<double, 2>> window;  ///< s: the part of a history that `reduce` looks at
  SignRule sign = SignRule::as_is;    ///< how value, theory and limit are shown
  double offset = 0;                  ///< added to the value, in the unit and sign of the table: a length is the first one plus a displacement
  std::optional<std::string> theory;  ///< name of a theory value
  std::optional<double> reference;    ///< in its place: a number, in the unit and sign of the table
  std::optional<ReferenceTable> table;  ///< in its place, with l2: a whole history
  std::optional<std::string> scene;   ///< only of runs of that scene
  std::vector<std::string> methods;   ///< only of runs with these labels; empty: all
  bool is_of(const PlannedRun& run) const;
};

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
  Observed along;                             ///< path: what the abscissa is
  std::optional<std::string> theory;        ///< history, profile: a column of theory
  std::vector<std::string> cases, methods;  ///< empty: all
  std::optional<std::string> scene;         ///< whose theory; default: the first run's
};

/// The converged solution to compare with: the static one of the elastic body by FEM of high degree; or, with `ladder`, Richardson's limit of
/// that method's ladder, quantity by quantity.
struct LimitSpec {
  std::array<int, 3> divisions{};
  int degree = 4;
  std::string ladder;  ///< a method's label; empty: the static solution
};

/// What an error costs by each method: one scene and quantity of price.csv.
struct PriceSpec {
  std::string name, title;                      ///< name: in tables and names of files; title: for people
  std::string quantity;                         ///< of one scene
  Reference reference = Reference::limit;
  std::vector<double> errors{10, 5, 1, 0.1};    ///< percent
  std::optional<double> spacing;                ///< m: all methods compared at this spacing too
  std::string base;                             ///< the method that others must be finer than; empty: none
};

/// A question to `advise`, whose advice is followed and measured.
struct AdviceSpec {
  std::string scene, quantity;
  std::optional<double> error, within;  ///< percent; s
  double budget = 30;                   ///< s
  std::vector<Method> methods;          ///< empty: those of `femsph advise`
};

struct Study {
  std::string name, title, folder, file;
  std::map<std::string, Scene> scenes;  ///< by their file's name
  std::vector<PlannedRun> runs;
  std::vector<QuantitySpec> quantities;
  std::vector<PaperNumber> paper;
  std::vector<SeriesSpec> series;
  std::optional<LimitSpec> limit;            ///< of every scene that `limits` does not name
  std::map<std::string, LimitSpec> limits;   ///< by scene
  int repeat = 1;                            ///< how often every run is made, to know the spread of its time
  std::vector<PriceSpec> prices;
  std::vector<AdviceSpec> advice;
  std::vector<Study> collected;  ///< run too; their rows are this study's
  std::vector<Claim> claims;
  std::vector<Bound> bounds;              ///< some: the study's table is one of verdicts
  std::vector<Expectation> expectations;
};

/// Reads a study and its scenes, and finds everything wrong with study.toml in one go. Throws InputError.
Study read_study(const std::string& file);
/// The same from memory; scenes are looked for beside `file`.
Study parse_study(const std::string& text, const std::string& file);

/// `femsph study NAME|FILE`.
struct StudyCommand {
  std::string name;             ///< a study's name, its folder, or its study.toml
  std::string out = "results";  ///< the study writes OUT/NAME/
  bool quick = false;
  int threads = 1;
  bool update_readme = false;  ///< rewrite the table in the study's README.md
  std::string program;         ///< argv[0], to find the studies that come with the program
  std::string command;         ///< the command line, for the records
};

/// Runs a study and writes its tables, data and figures. Returns the exit code: 0, or 3 when a run, a figure or a claim's row is missing.
/// Throws InputError or std::runtime_error when the study cannot be started or its results cannot be written.
int study_command(const StudyCommand& command);

/// `femsph list`: the studies found, the methods and the theory values. Returns 0.
int list_command(const std::string& program);

/// The folder that holds the studies: $FEMSPH_STUDIES, else ./studies, else ../../studies beside the program. Throws std::runtime_error.
std::string studies_folder(const std::string& program);

}  // namespace femsph::compare
