// The program `femsph`: reads the command line and calls a command (command_*.cpp).

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <thread>

#include "compare/program/manual.hpp"
#include "compare/program/options.hpp"
#include "compare/run/interruption.hpp"
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

Exit complain(const std::string& text, Exit code) {
  fmt::print(stderr, "femsph: {}\n", text);
  return code;
}

/// `femsph check` without a solver only reads the scene: the options of a discretization would do nothing.
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
  StudyCommand study;
  RunCommand run, check;
  ResumeCommand resume;
  PointCommand point;
  AdviseCommand advise;
  study.threads = run.threads = check.threads = int(std::max(1u, std::thread::hardware_concurrency()));
  const CLI::App *study_app = add_study(app, study), *run_app = add_run(app, run),
                 *resume_app = add_resume(app, resume);
  CLI::App* check_app = add_check(app, check);
  const CLI::App *point_app = add_point(app, point), *advise_app = add_advise(app, advise);

  CLI::App* list_app = app.add_subcommand(
      "list",
      "list the studies, and the words that scenes, studies and the command line take: laws, shapes, "
      "methods, quantities, ..");

  HelpCommand help;
  const CLI::App* help_app = add_help(app, help);
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
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the size limit is then a write error, like a full disk
  try {
    return run_program(argc, argv);
  } catch (const InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return bad_input;
  } catch (const BadCommand& error) {
    return complain(error.what(), bad_command);
  } catch (const Interrupted& error) {
    return complain(error.what(), interrupted);
  } catch (const Stopped& error) {
    return complain(error.what(), stopped);
  } catch (const MotionError& error) {
    return complain(error.what(), bad_run);
  } catch (const Refusal& error) {
    return complain(error.what(), bad_run);
  } catch (const std::bad_alloc&) {
    return complain(
        "out of memory; use a coarser spacing (`femsph check` estimates the memory)", bad_machine);
  } catch (const std::exception& error) {
    return complain(error.what(), bad_machine);
  }
}
