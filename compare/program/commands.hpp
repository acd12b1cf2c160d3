#pragma once
// The options of every command, and the function that carries it out.

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "compare/run/run.hpp"
#include "compare/study/study_runner.hpp"

namespace femsph::compare {

/// `femsph run`, and the options it shares with `femsph check`.
struct RunCommand {
  std::string scene;
  std::string solver;  ///< sph, fem, a method's name, or a method for each body
  std::optional<std::string> spacing;
  std::vector<int> divisions;
  /// Options of the method (compare/run/plan/method_options.cpp) by their words.
  std::map<std::string, std::optional<double>> numbers;
  std::map<std::string, std::optional<std::string>> words;
  std::vector<double> viscosity;  ///< --viscosity: alpha, beta, gamma
  bool projection = true;         ///< false: --no-projection
  double safety = 0.9;
  int threads = 1;
  std::string out;
  bool fields = true;
  std::string command;                    ///< the command line, for the record
  std::vector<std::string> arguments;     ///< the same, word by word, for a checkpoint
  std::optional<std::string> checkpoint;  ///< "1000" steps, or "10 min" of the wall clock
  /// `femsph resume`: start from here, instead of from the scene file.
  std::shared_ptr<const Checkpoint> from;
};

/// Returns the exit code. Throws what run_scene throws.
int run_command(const RunCommand& command);
/// Reads the scene and prints it; with a solver and a resolution also discretizes it, and prints particles or
/// elements, critical step, memory and time.
int check_command(const RunCommand& command);

/// `femsph resume`: everything else is in the checkpoint.
struct ResumeCommand {
  std::string folder;
  std::optional<std::string> checkpoint;
  std::optional<int> threads;
  bool any_program = false;  ///< accept a checkpoint of another build
};
int resume_command(const ResumeCommand& command);

/// `femsph point`: the stress of one material point along a path of strains.
struct PointCommand {
  std::string scene, material, path;
  std::string plane, integration;  ///< empty: as the scene says
  std::string out;                 ///< empty: to the terminal
};
int point_command(const PointCommand& command);

/// `femsph advise`: advice on a method and a spacing.
struct AdviseCommand {
  std::string scene;
  std::string error, within;  ///< one of them: "1%" or "0.01"; "10 min"
  /// Empty: the first probe; its largest component; its last value if the scene settles, else its peak.
  std::string probe, component, reduce;
  /// Empty: the four elements, classic (share) and corrected SPH. A text with "=" has a method for each body.
  std::vector<std::string> methods;
  std::string budget = "30 s";
  double safety = 0.98;
  bool run = false;  ///< also make the advised run
};
/// Returns the exit code: 0, or 3 when there is no advice. Throws BadCommand.
int advise_command(const AdviseCommand& command);

/// A mistake in the command line, in one sentence.
class BadCommand : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr int most_threads = 512, most_divisions = 1'000'000;

/// The methods and resolution of a command line. Throw BadCommand, with "did you mean", for unknown words,
/// for numbers out of their range and for options that would do nothing.
BodyMethods methods_of(const RunCommand& command, const Scene& scene);
Resolution resolution_of(const RunCommand& command, const Scene& scene, const BodyMethods& methods);
/// On stderr, for each option that applies to the methods of some bodies only: "note: --smoothing applies to
/// bar only".
void print_partial_options(const RunCommand& command, const BodyMethods& methods);
/// Return the number, or throw BadCommand if it is out of its range.
int checked_threads(int threads);
double checked_safety(double safety);

/// "warning: TEXT" on stderr.
void print_warning(const std::string& text);

/// Version, git state, compiler, libraries: a line each.
std::string version_text();

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

/// Runs a study and writes its tables, data and figures. Returns the exit code: 0, or 3 when a run, a figure
/// or a claim's row is missing. Throws InputError or std::runtime_error when the study cannot be started or
/// its results cannot be written.
int study_command(const StudyCommand& command);

/// `femsph list`: the studies found, and every catalogue (catalogues.hpp). Returns 0.
int list_command(const std::string& program);

/// `femsph help scene`, `femsph help study`: the page of keys. With `write`, the folder of the sources:
/// writes the pages into its docs/, and the catalogues' tables into its READMEs. Throws BadCommand.
struct HelpCommand {
  std::string topic, write;
};
int help_command(const HelpCommand& command);

/// The folder that holds the studies: $FEMSPH_STUDIES, else ./studies, else beside the program
/// ../share/femsph/studies (installed) or ../../studies (build tree). Throws BadCommand.
std::string studies_folder(const std::string& program);

/// The names of the studies in a folder.
std::vector<std::string> studies_in(const std::string& folder);

/// The same with another engine.
int study_command(const StudyCommand& command, const Engine& engine);

}  // namespace femsph::compare
