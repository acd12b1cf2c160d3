#include "compare/program/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "compare/run/plan/method_option.hpp"

namespace femsph::compare {
namespace {

// Options of several commands.

void add_scene(CLI::App* command, std::string& scene) {
  command->add_option("scene", scene, "scene file (TOML)")->required();
}

void add_threads(CLI::App* command, int& threads) {
  command->add_option("--threads", threads, "number of threads, up to 512; results do not depend on it")
      ->default_str("all");
}

void add_safety(CLI::App* command, double& safety) {
  command->add_option("--safety", safety, "step = safety x critical step; above 0, up to 1")
      ->capture_default_str();
}

void add_method_options(CLI::App* command, RunCommand& c) {
  add_scene(command, c.scene);
  command
      ->add_option("--solver", c.solver,
                   "sph (sph-corrected) or fem (fem-full), or a method's full name: see `femsph list`; or a "
                   "method for "
                   "each body: bar=sph,plate=fem; an entry without a body is for all others: fem,bar=sph")
      ->required();
  command->add_option("--spacing", c.spacing, "particle spacing, or edge of a cell: \"10 mm\"");
  command
      ->add_option(
          "--divisions", c.divisions, "cells along the axes of every body, instead of a spacing: 100,10")
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
  command->add_option("--viscosity", c.viscosity, "classic SPH: alpha,beta,gamma of the artificial viscosity")
      ->delimiter(',')
      ->expected(3);
  command->add_flag("!--no-projection", c.projection,
                    "sph-corrected: do not project the weights of scattered particles; a uniform stress is "
                    "then not exact");
  add_safety(command, c.safety);
  add_threads(command, c.threads);
}

void add_run_options(CLI::App* command, RunCommand& c) {
  add_method_options(command, c);
  command->add_option("--out", c.out, "folder for results")->required();
  command->add_flag("!--no-fields", c.fields, "write no fields (histories and record only)");
  command->add_option(
      "--checkpoint", c.checkpoint,
      "write OUT/checkpoint.h5 after every so many steps (1000), or at intervals of wall time "
      "(\"10 min\"), for `femsph resume OUT`;\n"
      "an interruption (SIGINT, SIGTERM) writes one in any case");
  command->footer(exit_codes);
}

}  // namespace

const char* const exit_codes =
    "Exit codes: 0 done; 1 bad input (scene, study, checkpoint); 2 bad command line (also a number out of "
    "its\n"
    "range, or an option that would do nothing); 3 a run that cannot begin (the method refuses the scene,\n"
    "bodies overlap, nothing can move, ..), a run with [settling] that did not settle (its results are\n"
    "written), a study with missing results, or no advice; 4 the machine (files, disk, memory); 5 a watch\n"
    "stopped the run: the message says where and why; 6 interrupted (SIGINT, SIGTERM): `femsph resume`\n"
    "continues it.";

CLI::App* add_study(CLI::App& app, StudyCommand& c) {
  CLI::App* command = app.add_subcommand(
      "study", "run a study: matched runs, a table of their errors and CPU times, figures");
  command
      ->add_option(
          "name", c.name, "name of a folder in studies/ (see `femsph list`), or path of a study file")
      ->required();
  command->add_option("--out", c.out, "folder for results; the study writes into a subfolder with its name")
      ->capture_default_str();
  command->add_flag("--quick", c.quick, "coarse cases only");
  command->add_flag("--update-readme", c.update_readme, "write the table into the study's README.md");
  add_threads(command, c.threads);
  return command;
}

CLI::App* add_run(CLI::App& app, RunCommand& c) {
  CLI::App* command = app.add_subcommand(
      "run", "run one scene by one method; write fields, histories and the run record");
  add_run_options(command, c);
  return command;
}

CLI::App* add_resume(CLI::App& app, ResumeCommand& c) {
  CLI::App* command = app.add_subcommand(
      "resume",
      "continue an interrupted run from its last checkpoint; the results are those of an uninterrupted run");
  command->add_option("folder", c.folder, "the run's folder (its --out)")->required();
  command->add_option("--checkpoint", c.checkpoint, "as for `femsph run` (default: as that run)");
  command->add_option("--threads", c.threads, "number of threads (default: as that run)");
  command->add_flag("--any-program", c.any_program,
                    "accept a checkpoint of another build of femsph; the results may then differ");
  command->footer(exit_codes);
  return command;
}

CLI::App* add_check(CLI::App& app, RunCommand& c) {
  CLI::App* command = app.add_subcommand(
      "check",
      "check a scene without running it; with --solver and a spacing also print particles or cells, critical "
      "step, memory and time");
  add_method_options(command, c);
  command->get_option("--solver")->required(false);
  return command;
}

CLI::App* add_point(CLI::App& app, PointCommand& c) {
  CLI::App* command = app.add_subcommand(
      "point", "stress of one material point along a path of strains; no discretization");
  add_scene(command, c.scene);
  command->add_option("--material", c.material, "a material of the scene")->required();
  command
      ->add_option("--path", c.path,
                   "CSV of total strains, one row a step: exx,eyy,gxy or exx,eyy,ezz,gxy,gyz,gzx (g = 2 e)")
      ->required();
  command->add_option("--plane", c.plane, "stress, strain or none (default: the scene's)");
  command->add_option("--integration", c.integration,
                      "return, no-return-1, no-return-3 or no-return-8 (default: the material's)");
  command->add_option("--out", c.out, "CSV to write (default: the terminal)");
  return command;
}

CLI::App* add_advise(CLI::App& app, AdviseCommand& c) {
  CLI::App* command = app.add_subcommand(
      "advise",
      "advise a method and a spacing: runs the scene by each method at a few spacings, from coarse to fine; "
      "times are CPU times of one thread");
  add_scene(command, c.scene);
  command->add_option("--error", c.error, "find the least time for this error: 1% or 0.01");
  command->add_option("--within", c.within, "find the least error in this time: \"10 min\"");
  command->add_option("--probe", c.probe, "the probe whose error counts (default: the first of the scene)");
  command->add_option("--component", c.component, "its component: x, y, xx, .. (default: the largest)");
  command->add_option("--reduce", c.reduce,
                      "final, peak or mean of its history (default: final if the scene settles, else peak)");
  command->add_option(
      "--methods", c.methods,
      "methods to choose from (default: the four elements, sph-classic-share, sph-corrected): "
      "fem-full,sph-corrected; a method for each body is a word of its own: "
      "--methods fem-full bar=sph-corrected,plate=fem-full");
  command->add_option("--budget", c.budget, "CPU time for all these runs together")->capture_default_str();
  add_safety(command, c.safety);
  command->add_flag("--run", c.run, "also make the advised run, and compare it with the prediction");
  return command;
}

CLI::App* add_help(CLI::App& app, HelpCommand& c) {
  CLI::App* command = app.add_subcommand("help", "print every key of a scene or of a study");
  command->add_option("topic", c.topic, "scene or study");
  command->add_option("--write", c.write,
                      "folder of the sources: write docs/scene-keys.md, docs/study-keys.md and the tables of "
                      "words in the READMEs");
  return command;
}

}  // namespace femsph::compare
