// The program `femsph`: one subcommand a file (command_*.cpp).

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <thread>

#include "compare/program/commands.hpp"
#include "compare/program/manual.hpp"
#include "compare/run/interruption.hpp"
#include "compare/run/plan/method_option.hpp"
#include "compare/run/run_output.hpp"
#include "compare/study/reader/study.hpp"
#include "model/input/faults.hpp"
#include "model/motion/march.hpp"
#include "model/results/record.hpp"

namespace {

using namespace femsph;
using namespace femsph::compare;

enum Exit {
  done = 0,
  bad_input = 1,
  bad_command = 2,
  bad_run = 3,
  bad_machine = 4,
  stopped = 5,
  interrupted = 6
};

const char* const exit_codes =
    "Exit codes: 0 done; 1 bad input (scene, study, checkpoint); 2 bad command line (also a number out of "
    "its range, or an option that\n"
    "would do nothing); 3 a run that cannot begin (the method refuses the scene, bodies overlap, nothing can "
    "move, ..), one with\n"
    "[settling] that did not settle (its results are written), a study of which something is\n"
    "missing, or no advice; 4 the machine (files, disk, memory); 5 a watch stopped the run: the message says "
    "where and why; 6 interrupted (SIGINT, SIGTERM): `femsph resume` goes on.";

void add_method_options(CLI::App* command, RunCommand& c) {
  command->add_option("scene", c.scene, "scene file (TOML)")->required();
  command
      ->add_option("--solver", c.solver,
                   "sph (sph-corrected) or fem (fem-full), or a method's full name: see `femsph list`")
      ->required();
  command->add_option("--spacing", c.spacing, "particle spacing, or edge of a cell: \"10 mm\"");
  command
      ->add_option(
          "--divisions", c.divisions, "cells along each axis of every body, in place of a spacing: 100,10")
      ->delimiter(',')
      ->expected(1, 3);
  for (const MethodOption& option : method_options()) {
    if (!option.on_command_line) continue;
    std::string flag = "--" + option.word;
    std::replace(flag.begin(), flag.end(), '_', '-');
    const std::string about = fmt::format("{}; {}", option.about, option.holds());
    if (option.range)
      command->add_option(flag, c.numbers[option.word], about);
    else
      command->add_option(flag, c.words[option.word], about);
  }
  command
      ->add_option(
          "--viscosity", c.viscosity, "classic SPH: alpha,beta,gamma of the artificial viscosity (eq. 5)")
      ->delimiter(',')
      ->expected(3);
  command->add_flag("!--no-projection", c.projection,
                    "sph-corrected: leave the weights of scattered particles as the kernel has them; a "
                    "uniform stress is then not exact");
  command->add_option("--safety", c.safety, "step = safety x critical step; above 0, up to 1")
      ->capture_default_str();
  command->add_option("--threads", c.threads, "threads of every loop, up to 512")->default_str("all");
}

void add_run_options(CLI::App* command, RunCommand& c) {
  add_method_options(command, c);
  command->add_option("--out", c.out, "folder for results")->required();
  command->add_flag("!--no-fields", c.fields, "write no fields (histories and record only)");
  command->add_option("--checkpoint", c.checkpoint,
                      "write OUT/checkpoint.h5 every so many steps (1000) or so often on the clock (\"10 "
                      "min\"), for `femsph resume OUT`;\n"
                      "an interruption (SIGINT, SIGTERM) writes one in any case");
  command->footer(exit_codes);
}

/// `femsph resume`: what it needs beside the folder stands in the checkpoint.
struct ResumeCommand {
  std::string folder;
  std::optional<std::string> checkpoint;
  std::optional<int> threads;
  bool any_program = false;
};

int resume_command(const ResumeCommand& resume) {
  RunCommand run;
  run.from = std::make_shared<Checkpoint>(checkpoint_file(resume.folder), resume.any_program);
  run.arguments = run.from->origin().arguments;
  run.threads = resume.threads.value_or(int(std::max(1u, std::thread::hardware_concurrency())));
  CLI::App app;
  add_run_options(app.add_subcommand("run"), run);
  std::vector<std::string> reversed(run.arguments.rbegin(), run.arguments.rend());
  for (const std::string& word : run.arguments) run.command += (run.command.empty() ? "" : " ") + word;
  if (!reversed.empty()) reversed.pop_back();  // the program
  app.parse(reversed);
  run.out = resume.folder;
  if (resume.threads) run.threads = *resume.threads;
  if (resume.checkpoint) run.checkpoint = resume.checkpoint;
  fmt::print(stderr, "goes on from {}\n", run.from->origin().progress);
  return run_command(run);
}

/// `femsph check` without a solver only reads the scene: what belongs to a discretization would do nothing.
void refuse_without_solver(CLI::App& check) {
  if (check.get_option("--solver")->count() > 0) {
    if (check.get_option("--solver")->as<std::string>().empty())
      throw BadCommand("--solver is empty; expected sph, fem or a method's name");
    return;
  }
  for (const CLI::Option* option : check.get_options())
    if (option->count() > 0 && option->get_name() != "scene")
      throw BadCommand(fmt::format("{} does nothing without --solver", option->get_name()));
}

int run_program(int argc, char** argv) {
  CLI::App app(
      "femsph compares SPH and explicit FEM for solid dynamics: one scene, two discretizations, one table.");
  app.set_version_flag("--version", [] { return version_text(); });
  app.require_subcommand(1);
  app.footer(exit_codes);
  add_provenance("deal.II", fem::deal_ii_version());
  const int all = int(std::max(1u, std::thread::hardware_concurrency()));

  StudyCommand study;
  study.threads = all;
  CLI::App* study_app = app.add_subcommand(
      "study", "run a study: matched cases, a table of errors and prices, figures");
  study_app->add_option("name", study.name, "name of a folder in studies/, or path of a study file")
      ->required();
  study_app->add_option("--out", study.out, "folder for results; the study writes into its own subfolder")
      ->capture_default_str();
  study_app->add_flag("--quick", study.quick, "the short form: coarse cases only");
  study_app->add_flag("--update-readme", study.update_readme, "write the table into the study's README.md");
  study_app->add_option("--threads", study.threads, "threads of every loop, up to 512")->default_str("all");

  RunCommand run;
  run.threads = all;
  CLI::App* run_app = app.add_subcommand(
      "run", "run one scene by one method; write fields, histories and the run record");
  add_run_options(run_app, run);

  ResumeCommand resume;
  CLI::App* resume_app = app.add_subcommand(
      "resume",
      "go on with a run that was interrupted, from its last "
      "checkpoint; the results are those of an uninterrupted run");
  resume_app->add_option("folder", resume.folder, "the run's folder (its --out)")->required();
  resume_app->add_option("--checkpoint", resume.checkpoint, "as for `femsph run` (default: as that run)");
  resume_app->add_option("--threads", resume.threads, "threads of every loop (default: as that run)");
  resume_app->add_flag("--any-program", resume.any_program,
                       "also from a checkpoint of another build of femsph; results may differ then");
  resume_app->footer(exit_codes);

  RunCommand check;
  check.threads = all;
  CLI::App* check_app = app.add_subcommand(
      "check", "read a scene and print what follows from it; runs nothing");
  add_method_options(check_app, check);
  check_app->get_option("--solver")->required(false);

  PointCommand point;
  CLI::App* point_app = app.add_subcommand(
      "point", "drive the law of one material along a path of strains; no discretization");
  point_app->add_option("scene", point.scene, "scene file (TOML)")->required();
  point_app->add_option("--material", point.material, "a material of the scene")->required();
  point_app
      ->add_option("--path", point.path,
                   "CSV of total strains, one row a step: exx,eyy,gxy or exx,eyy,ezz,gxy,gyz,gzx (g = 2 e)")
      ->required();
  point_app->add_option("--plane", point.plane, "stress, strain or none (default: the scene's)");
  point_app->add_option("--integration", point.integration,
                        "return, no-return-1, no-return-3 or no-return-8 (default: the material's)");
  point_app->add_option("--out", point.out, "CSV to write (default: the terminal)");

  AdviseCommand advise;
  CLI::App* advise_app = app.add_subcommand(
      "advise",
      "which method, how fine? a short ladder of the scene by each "
      "method, and what it says; times are CPU times of one thread");
  advise_app->add_option("scene", advise.scene, "scene file (TOML)")->required();
  advise_app->add_option("--error", advise.error, "the least time for this error: 1% or 0.01");
  advise_app->add_option("--within", advise.within, "the least error in this time: \"10 min\"");
  advise_app->add_option("--probe", advise.probe, "of which probe (default: the scene's first)");
  advise_app->add_option(
      "--component", advise.component, "of which component: x, y, xx, .. (default: the largest)");
  advise_app->add_option(
      "--reduce", advise.reduce, "final, peak or mean (default: final of a scene that settles, else peak)");
  advise_app
      ->add_option("--methods", advise.methods,
                   "by which methods (default: the four elements, sph-classic-share, sph-corrected)")
      ->delimiter(',');
  advise_app->add_option("--budget", advise.budget, "CPU time for all ladders together")
      ->capture_default_str();
  advise_app->add_option("--safety", advise.safety, "step = safety x critical step; above 0, up to 1")
      ->capture_default_str();
  advise_app->add_flag("--run", advise.run, "make the advised run too, and say how it went");

  CLI::App* list_app = app.add_subcommand(
      "list", "list studies, and every word of a scene, a study and the command line");

  HelpCommand help;
  CLI::App* help_app = app.add_subcommand("help", "every key of a scene or of a study");
  help_app->add_option("topic", help.topic, "scene or study");
  help_app->add_option("--write", help.write,
                       "folder of the sources: write docs/scene-keys.md, docs/study-keys.md and the READMEs' "
                       "tables of words");

  std::string shell;  // hidden: what the build installs
  CLI::App* manual_app = app.add_subcommand("manual", "print femsph(1), or --completion bash")->group("");
  manual_app->add_option("--completion", shell, "bash");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : bad_command;
  }
  run.arguments.assign(argv, argv + argc);
  for (int i = 0; i < argc; ++i) run.command += (i ? " " : "") + std::string(argv[i]);
  study.command = run.command;
  study.program = argv[0];
  if (*study_app) return study_command(study);
  if (*run_app) return run_command(run);
  if (*resume_app) return resume_command(resume);
  if (*check_app) {
    refuse_without_solver(*check_app);
    return check_command(check);
  }
  if (*point_app) return point_command(point);
  if (*advise_app) return advise_command(advise);
  if (*list_app) return list_command(argv[0]);
  if (*manual_app) {
    if (!shell.empty() && shell != "bash")
      throw BadCommand(fmt::format("--completion cannot be {}; expected bash", in_quotes(shell)));
    fmt::print("{}", shell.empty() ? manual_page(app, version_line(), exit_codes)
                                   : bash_completion(app, option_words()));
    return done;
  }
  if (*help_app) return help_command(help);
  return bad_command;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file over the limit is an error of writing, like a full disk
  try {
    return run_program(argc, argv);
  } catch (const femsph::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return bad_input;
  } catch (const BadCommand& error) {
    fmt::print(stderr, "femsph: {}\n", error.what());
    return bad_command;
  } catch (const femsph::compare::Interrupted& leave) {
    fmt::print(stderr, "femsph: {}\n", leave.what());
    return interrupted;
  } catch (const femsph::Stopped& error) {
    fmt::print(stderr, "femsph: {}\n", error.what());
    return stopped;
  } catch (const femsph::MotionError& error) {
    fmt::print(stderr, "femsph: {}\n", error.what());
    return bad_run;
  } catch (const femsph::Refusal& error) {
    fmt::print(stderr, "femsph: {}\n", error.what());
    return bad_run;
  } catch (const std::bad_alloc&) {
    fmt::print(
        stderr, "femsph: out of memory; take a coarser spacing (`femsph check` estimates the memory)\n");
    return bad_machine;
  } catch (const std::exception& error) {
    fmt::print(stderr, "femsph: {}\n", error.what());
    return bad_machine;
  }
}
