#pragma once
// The manual page and the shell completion. They are written from the same subcommands and options that read
// the command line, so that they cannot differ from it.

#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace femsph::compare {

/// The words that an option's value is chosen from, by the option's name ("--kernel").
using OptionWords = std::map<std::string, std::vector<std::string>>;
OptionWords option_words();

/// femsph(1), as troff for man. `version` is version_line(), `exit_codes` the text of EXIT STATUS.
std::string manual_page(const CLI::App& app, const std::string& version, const std::string& exit_codes);

/// A script for bash, to be sourced: completes subcommands, options, words, studies and files.
std::string bash_completion(const CLI::App& app, const OptionWords& words);

}  // namespace femsph::compare
