#include "compare/program/manual.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "compare/reference/theory.hpp"
#include "compare/run/plan/method.hpp"

namespace femsph::compare {
namespace {

using Options = std::vector<const CLI::Option*>;

/// A subcommand without a group is not shown to users.
std::vector<const CLI::App*> shown(const CLI::App& app) {
  std::vector<const CLI::App*> commands;
  for (const CLI::App* command :
       app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); }))
    commands.push_back(command);
  return commands;
}

/// Escapes a text for troff: hyphens stay ASCII hyphens, and no line begins with a request.
std::string troff(const std::string& text) {
  std::string out;
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '-' || c == '\\') out += '\\';
    out += c == '\\' ? 'e' : c;
    begins = c == '\n';
  }
  return out;
}

bool is_flag(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

/// "--out PATH", "name".
std::string heading(const CLI::Option& option) {
  if (option.get_positional()) return fmt::format("\\fI{}\\fR", troff(option.get_single_name()));
  std::string text;
  for (const std::string& name : option.get_snames())
    text += fmt::format("{}\\fB\\-{}\\fR", text.empty() ? "" : ", ", troff(name));
  for (const std::string& name : option.get_lnames())
    text += fmt::format("{}\\fB\\-\\-{}\\fR", text.empty() ? "" : ", ", troff(name));
  return is_flag(option) ? text : text + fmt::format(" \\fI{}\\fR", troff(option.get_type_name()));
}

std::string options_section(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : app.get_options()) {
    text += fmt::format(".TP\n{}\n{}", heading(*option), troff(option->get_description()));
    if (option->get_required()) text += " (required)";
    if (!is_flag(*option) && !option->get_default_str().empty())
      text += fmt::format(" (default: {})", troff(option->get_default_str()));
    text += "\n";
  }
  return text;
}

std::string synopsis(const CLI::App& command) {
  std::string text = fmt::format(".B femsph {}\n", command.get_name());
  bool optional = false;
  for (const CLI::Option* option : command.get_options()) {
    const std::string given = heading(*option);
    if (option->get_required())
      text += given + "\n";
    else if (option->get_positional())
      text += fmt::format("[{}]\n", given);
    else
      optional = true;
  }
  return text + (optional ? "[\\fIoptions\\fR]\n.br\n" : ".br\n");
}

std::string spaced(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// The long and short names of a command's options.
std::vector<std::string> names_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

const char* const completion_tail = R"BASH(
_femsph_studies() {  # the names of the studies that the program would find
  local folder study program
  local -a folders=("${FEMSPH_STUDIES:-studies}")
  program=$(type -P "${COMP_WORDS[0]}")
  [ -n "$program" ] && folders+=("$(dirname "$(readlink -f "$program")")/../share/femsph/studies")
  for folder in "${folders[@]}"; do
    [ -d "$folder" ] || continue
    for study in "$folder"/*/study.toml; do
      [ -e "$study" ] && basename "$(dirname "$study")"
    done
    return
  done
}

_femsph() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command="" i words
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case " $_femsph_commands " in *" ${COMP_WORDS[i]} "*) command=${COMP_WORDS[i]}; break ;; esac
  done
  words=$(_femsph_words "$before")
  if [ -n "$words" ]; then
    COMPREPLY=($(compgen -W "$words" -- "$word"))
  elif [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$(_femsph_options "$command")" -- "$word"))
  elif [ -z "$command" ]; then
    COMPREPLY=($(compgen -W "$_femsph_commands" -- "$word"))
  elif [ "$command" = study ] && [ "$before" = study ]; then
    COMPREPLY=($(compgen -W "$(_femsph_studies)" -- "$word") $(compgen -f -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}
complete -o filenames -F _femsph femsph
)BASH";

}  // namespace

std::string manual_page(const CLI::App& app, const std::string& version, const std::string& exit_codes) {
  std::string text = fmt::format(
      ".\\\" Written by `femsph manual`.\n.TH FEMSPH 1 \"\" \"{}\" \"User Commands\"\n.SH NAME\n"
      "femsph \\- SPH and explicit FEM for solid dynamics, compared on one scene\n.SH SYNOPSIS\n",
      version.substr(0, version.find(" (")));  // without the git state
  for (const CLI::App* command : shown(app)) text += synopsis(*command);
  text += fmt::format(
      ".SH DESCRIPTION\n{}\n.SH OPTIONS\n{}", troff(app.get_description()), options_section(app));
  text += ".SH COMMANDS\n";
  for (const CLI::App* command : shown(app))
    text += fmt::format(".SS {}\n{}\n{}", troff(command->get_name()), troff(command->get_description()),
                        options_section(*command));
  text += ".SH METHODS\n";
  for (const Method& method : methods())
    text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", troff(method.name), troff(method.about));
  text += ".SH THEORY VALUES\nReference values that a study can compare with.\n";
  for (const Theory& theory : theories())
    text += fmt::format(
        ".TP\n\\fB{}\\fR ({})\n{}\n", troff(theory.name), troff(theory.unit), troff(theory.formula));
  return text + fmt::format(
                    ".SH EXIT STATUS\n{}\n.SH ENVIRONMENT\n.TP\n\\fBFEMSPH_STUDIES\\fR\nthe folder of the "
                    "studies, instead of ./studies and of the installed studies\n",
                    troff(exit_codes));
}

std::string bash_completion(const CLI::App& app, const OptionWords& words) {
  std::vector<std::string> commands;
  for (const CLI::App* command : shown(app)) commands.push_back(command->get_name());
  std::string text = fmt::format(
      "# bash completion for femsph, written by `femsph manual --completion bash`.\n\n"
      "_femsph_commands=\"{}\"\n\n_femsph_options() {{  # of a command\n  case $1 in\n",
      spaced(commands));
  for (const CLI::App* command : shown(app))
    text += fmt::format("    {}) echo \"{}\" ;;\n", command->get_name(), spaced(names_of(*command)));
  text += fmt::format("    *) echo \"{}\" ;;\n  esac\n}}\n\n", spaced(names_of(app)));
  text += "_femsph_words() {  # that the value of an option is chosen from\n  case $1 in\n";
  for (const auto& [option, choice] : words)
    text += fmt::format("    {}) echo \"{}\" ;;\n", option, spaced(choice));
  return text + "  esac\n}\n" + completion_tail;
}

}  // namespace femsph::compare
