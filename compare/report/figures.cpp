#include "compare/report/figures.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

extern char** environ;

namespace femsph::compare {
namespace {

// A text in single quotes for gnuplot. Within them only the single quote is special.
std::string gnuplot_text(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

// Runs gnuplot without a shell; its output goes to a file. Returns its exit status; 127 if there is no
// gnuplot.
int run_gnuplot(const std::string& settings, const std::string& script, const std::string& log) {
  std::vector<std::string> words = {"gnuplot", "-e", settings, script};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed == ENOENT) return 127;
  if (failed)
    throw std::runtime_error(fmt::format("figures: gnuplot cannot be started: {}", std::strerror(failed)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

// The last line of gnuplot's output that is not empty: its error message, with the place in the script.
std::string last_line(const std::string& file) {
  std::ifstream in(file);
  std::string last;
  for (std::string line; std::getline(in, line);)
    if (line.find_first_not_of(" \t^") != std::string::npos) last = line;
  return last.substr(0, last.find_last_not_of(" \t") + 1);
}

}  // namespace

void make_figures(const std::string& script, const std::string& style, const std::string& data,
                  const std::string& out) {
  namespace fs = std::filesystem;
  const std::string log = (fs::path(out) / "gnuplot.log").string();
  for (const std::string format : {"svg", "png"}) {
    const std::string settings = fmt::format(
        "format = '{}'; style = {}; data = {}; out = {}", format, gnuplot_text(fs::absolute(style).string()),
        gnuplot_text(fs::absolute(data).string()), gnuplot_text(fs::absolute(out).string()));
    const int status = run_gnuplot(settings, script, log);
    if (status == 127)
      throw std::runtime_error(
          "figures: gnuplot was not found; the tables and data are written; install gnuplot to get the "
          "figures");
    if (status != 0)
      throw std::runtime_error(
          fmt::format("figures: {} failed: {} (the whole output is in {})", script, last_line(log), log));
  }
  std::error_code ignored;
  fs::remove(log, ignored);
}

}  // namespace femsph::compare
