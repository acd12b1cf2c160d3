// `femsph resume`: reads the command line again that the checkpoint holds, and continues the run.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "compare/program/options.hpp"
#include "compare/run/run_output.hpp"

namespace femsph::compare {

int resume_command(const ResumeCommand& resume) {
  RunCommand run;
  run.from = std::make_shared<Checkpoint>(checkpoint_file(resume.folder), resume.any_program);
  run.arguments = run.from->origin().arguments;
  run.threads = resume.threads.value_or(int(std::max(1u, std::thread::hardware_concurrency())));
  CLI::App app;
  add_run(app, run);
  std::vector<std::string> reversed(run.arguments.rbegin(), run.arguments.rend());
  for (const std::string& word : run.arguments) run.command += (run.command.empty() ? "" : " ") + word;
  if (!reversed.empty()) reversed.pop_back();  // the program
  app.parse(reversed);
  run.out = resume.folder;
  if (resume.threads) run.threads = *resume.threads;
  if (resume.checkpoint) run.checkpoint = resume.checkpoint;
  fmt::print(stderr, "continues from {}\n", run.from->origin().progress);
  return run_command(run);
}

}  // namespace femsph::compare
