#pragma once
// The subcommands and their options. The command line, the manual page and the shell completion are made from
// them. Each add_.. returns the subcommand; its options write into `c`.

#include "compare/program/commands.hpp"

namespace CLI {
class App;
}

namespace femsph::compare {

/// The meaning of the exit codes, for the end of help texts.
extern const char* const exit_codes;

CLI::App* add_study(CLI::App& app, StudyCommand& c);
CLI::App* add_run(CLI::App& app, RunCommand& c);
CLI::App* add_resume(CLI::App& app, ResumeCommand& c);
CLI::App* add_check(CLI::App& app, RunCommand& c);
CLI::App* add_point(CLI::App& app, PointCommand& c);
CLI::App* add_advise(CLI::App& app, AdviseCommand& c);
CLI::App* add_help(CLI::App& app, HelpCommand& c);

}  // namespace femsph::compare
