// `femsph study`: finds a study, runs it and writes its tables, data and figures.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "compare/price/price_tables.hpp"
#include "compare/price/study_advice.hpp"
#include "compare/program/commands.hpp"
#include "compare/report/figures.hpp"
#include "compare/report/readme.hpp"
#include "compare/study/series.hpp"
#include "model/input/toml_fields.hpp"
#include "model/material/material.hpp"
#include "model/numerics/parallel.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph::compare {
namespace {

namespace fs = std::filesystem;

void print(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

void complain(const std::string& line) { fmt::print(stderr, "femsph: {}\n", line); }

/// The study.toml that the command line names: by its path, by its folder or by the name of a study.
std::string study_file(const StudyCommand& command) {
  if (fs::is_regular_file(command.name)) return command.name;
  if (fs::is_regular_file(fs::path(command.name) / "study.toml"))
    return (fs::path(command.name) / "study.toml").string();
  const std::string folder = studies_folder(command.program);
  const auto names = studies_in(folder);
  if (std::find(names.begin(), names.end(), command.name) == names.end())
    throw BadCommand(fmt::format(
        "no study is called {}; expected a folder or one of {} in {}{}", in_quotes(command.name),
        one_of(names), folder, did_you_mean(command.name, names)));
  return (fs::path(folder) / command.name / "study.toml").string();
}

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed)
    throw std::runtime_error(
        fmt::format("cannot create the folder {}: {}", folder.string(), failed.message()));
}

std::string markdown_of(const Study& study, const std::vector<Row>& rows) {
  return study.bounds.empty() ? markdown(rows, orders_of(rows))
                              : markdown(judge(study.bounds, study.expectations, rows));
}

// A study with bounds writes verdicts into table.csv, and the usual table into details.csv.
void write_tables(const Study& study, const std::vector<Row>& rows, const fs::path& folder) {
  const auto orders = orders_of(rows);
  const bool verdicts = !study.bounds.empty();
  if (verdicts)
    write_text(csv(judge(study.bounds, study.expectations, rows)), (folder / "table.csv").string());
  write_text(csv(rows), (folder / (verdicts ? "details.csv" : "table.csv")).string());
  write_text(markdown_of(study, rows), (folder / "table.md").string());
  write_text(csv(orders), (folder / "orders.csv").string());
}

int write_figures(const Study& study, const StudyCommand& command, const fs::path& folder) {
  const fs::path script = fs::path(study.folder) / "plot.gp";
  if (!fs::exists(script)) return 0;
  try {
    fs::path style = fs::path(study.folder) / ".." / "style.gp";
    if (!fs::exists(style)) style = fs::path(studies_folder(command.program)) / "style.gp";
    make_figures(script.string(), style.string(), (folder / "data").string(), folder.string());
    return 0;
  } catch (const std::runtime_error& e) {
    complain(e.what());
    return 1;
  }
}

int write_series(const Study& study, const StudyOutcome& outcome, const fs::path& folder) {
  int failures = 0;
  for (const SeriesSpec& series : study.series) {
    try {
      write_text(series_csv(series, study, outcome), (folder / "data" / series.file).string());
    } catch (const std::runtime_error& e) {
      complain(fmt::format("{}: the series {} is missing: {}", study.name, series.file, e.what()));
      ++failures;
    }
  }
  return failures;
}

/// Writes price.csv and its data. Returns the text for the README: with prices, their tables instead of the
/// long table of runs.
std::string write_prices(const Study& study, const std::vector<Row>& rows, const fs::path& folder,
                         const std::string& table) {
  if (study.prices.empty()) return table;
  const auto scenes = priced_scenes(study, rows);
  const std::string text = price_markdown(scenes);
  write_text(price_csv(scenes), (folder / "price.csv").string());
  write_text(spacing_csv(scenes), (folder / "price_at_spacing.csv").string());
  write_text(finer_csv(scenes), (folder / "finer.csv").string());
  write_text(ladders_csv(scenes), (folder / "data" / "ladders.csv").string());
  write_text(text, (folder / "price.md").string());
  for (const PricedScene& scene : scenes) {
    write_text(rungs_csv(scene), (folder / "data" / ("rungs-" + scene.spec->name + ".csv")).string());
    write_text(front_csv(scene), (folder / "data" / ("front-" + scene.spec->name + ".csv")).string());
  }
  return text;
}

int write_claims(const Study& study, const std::vector<Row>& rows, bool quick, const fs::path& folder,
                 std::string& table) {
  if (study.claims.empty()) return 0;
  const auto verdicts = judge(study.claims, rows);
  write_text(csv(verdicts), (folder / "claims.csv").string());
  write_text(markdown(verdicts), (folder / "claims.md").string());
  table = markdown(verdicts) + "\n" + table;
  int unknown = 0;
  for (const Verdict& verdict : verdicts) {
    if (verdict.holds != Verdict::Holds::unknown || quick) continue;
    complain(fmt::format("claim {}: {}", verdict.claim->id, verdict.note));
    ++unknown;
  }
  return unknown;
}

// Counts the rows that are neither stable nor fail as expected.
int complain_of_failed(const Study& study, const std::vector<Row>& rows) {
  int failed = 0;
  for (const JudgedRow& judged : judge(study.bounds, study.expectations, rows)) {
    if (judged.verdict != JudgedRow::Verdict::failed) continue;
    complain(fmt::format("{} {} {} {}: {}", study.name, judged.row->case_name, judged.row->method,
                         judged.row->quantity, judged.reason));
    ++failed;
  }
  return failed;
}

void update_readme(const Study& study, const std::string& table) {
  const std::string file = (fs::path(study.folder) / "README.md").string();
  try {
    write_text(with_table(read_text_file(file, "the study's README.md", Length::any), table), file);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(fmt::format("{}: {}", file, e.what()));
  }
}

// Runs a study and those that it collects, appends their rows, and returns the number of failures.
int run_one(const Study& study, const StudyCommand& command, const Engine& engine, std::vector<Row>& rows) {
  const fs::path top = fs::path(command.out) / study.name;
  make_folder(study.series.empty() && study.prices.empty() ? top : top / "data");
  int failures = 0;
  std::vector<Row> own;
  for (const Study& other : study.collected) failures += run_one(other, command, engine, own);

  StudyOptions options{command.quick, command.command, print,
                       [&](const StudyOutcome& so_far) { write_tables(study, so_far.rows, top); }};
  const StudyOutcome outcome = run_study(study, engine, options);
  failures += study.bounds.empty() ? outcome.failures : complain_of_failed(study, outcome.rows);
  own.insert(own.end(), outcome.rows.begin(), outcome.rows.end());
  write_tables(study, own, top);
  failures += write_series(study, outcome, top);
  std::string table = write_prices(study, own, top, markdown_of(study, own));
  if (!study.advice.empty() && !command.quick) {
    const auto followed = follow_advice(study, own, engine, print);
    failures += int(std::count_if(
        followed.begin(), followed.end(), [](const FollowedAdvice& one) { return !one.outcome; }));
    write_text(csv(followed), (top / "advice.csv").string());
    table += markdown(followed);
  }
  failures += write_claims(study, own, command.quick, top, table);
  failures += write_figures(study, command, top);
  if (command.update_readme) update_readme(study, table);
  print(fmt::format("{}: {}", study.name, (top / "table.md").string()));
  rows.insert(rows.end(), own.begin(), own.end());
  return failures;
}

}  // namespace

std::vector<std::string> studies_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (fs::exists(entry.path() / "study.toml", ignored)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string studies_folder(const std::string& program) {
  std::error_code ignored;
  if (const char* given = std::getenv("FEMSPH_STUDIES"); given && *given) {
    if (fs::is_directory(given, ignored)) return given;
    throw BadCommand(fmt::format("FEMSPH_STUDIES is {}, which is not a folder", in_quotes(given)));
  }
  if (fs::is_directory("studies", ignored)) return "studies";
  fs::path self = fs::read_symlink("/proc/self/exe", ignored);
  if (self.empty()) self = program;
  for (const char* beside : {"../share/femsph/studies", "../../studies"}) {  // installed; in the build tree
    const fs::path folder = (self.parent_path() / beside).lexically_normal();
    if (fs::is_directory(folder, ignored)) return folder.string();
  }
  throw BadCommand(
      "no folder of studies; expected ./studies, or its path in the environment variable FEMSPH_STUDIES");
}

int study_command(const StudyCommand& command) {
  return study_command(command, {run_scene, fem::static_limit});
}

int study_command(const StudyCommand& command, const Engine& engine) {
  set_threads(checked_threads(command.threads));
  const Study study = read_study(study_file(command));
  if (command.update_readme && command.quick)
    throw BadCommand("--update-readme with --quick; expected the full study, whose numbers a README states");
  std::vector<Row> rows;
  const double cpu = cpu_seconds(), wall = wall_seconds();
  const int failures = run_one(study, command, engine, rows);
  print(fmt::format("price: {:.3g} s CPU, {:.3g} s wall, peak memory {:.3g} MB", cpu_seconds() - cpu,
                    wall_seconds() - wall, double(peak_memory()) / 1e6));
  return failures == 0 ? 0 : 3;
}

}  // namespace femsph::compare
