// Runs the program as a user would, and looks at what it prints and leaves.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "case.hpp"
#include "numbers.hpp"

namespace femsph::field {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int code;
  std::string text;
};

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

Outcome shell(const std::string& command) {
  Outcome o{-1, {}};
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot start a shell");
  std::array<char, 4096> buffer;
  while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) o.text.append(buffer.data(), n);
  o.code = WEXITSTATUS(pclose(pipe));
  return o;
}

/// The scene, with its words replaced if the case wants that: then a file of its own in `folder`.
std::string scene_file(const Run& run, const std::string& scene, const std::string& folder,
                       const Setting& setting) {
  const std::string file = setting.scenes + "/" + scene + ".toml";
  if (run.replace.empty()) return file;
  std::string text = file_text(file);
  for (const auto& [from, to] : run.replace) {
    std::size_t at = text.find(from);
    if (at == std::string::npos)
      throw std::runtime_error(fmt::format("{}.toml holds no \"{}\" to replace", scene, from));
    for (; at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
  }
  const std::string meshes = fs::absolute(setting.scenes + "/../meshes/").lexically_normal().string();
  for (std::size_t at = text.find("../meshes/"); at != std::string::npos;
       at = text.find("../meshes/", at + meshes.size()))
    text.replace(at, 10, meshes);
  std::ofstream(folder + "/" + scene + ".toml") << text;
  return folder + "/" + scene + ".toml";
}

std::string first_lines(const std::string& text) {
  std::string line = text.substr(0, text.find('\n'));
  for (const char* word : {"error", "warning"})
    if (const auto at = text.find(word); at != std::string::npos) {
      line = text.substr(text.rfind('\n', at) == std::string::npos ? 0 : text.rfind('\n', at) + 1);
      line = line.substr(0, line.find('\n'));
      break;
    }
  if (const auto slash = line.find(".toml:"); slash != std::string::npos)  // without the folder before it
    if (const auto before = line.rfind('/', slash); before != std::string::npos)
      line = line.substr(before + 1);
  return line.size() > 160 ? line.substr(0, 157) + ".." : line;
}

/// Exit code and messages.
Finding look_at_words(const Run& run, const Outcome& o) {
  Finding finding{"", "", "", "", "", Verdict::pass};
  std::vector<std::string> missing;
  const bool refusal = std::find(run.exit.begin(), run.exit.end(), 0) == run.exit.end();
  if (std::find(run.exit.begin(), run.exit.end(), o.code) == run.exit.end())
    missing.push_back(fmt::format("exit code {}", o.code));
  for (const std::string& word : run.says)
    if (o.text.find(word) == std::string::npos) missing.push_back(fmt::format("no word of \"{}\"", word));
  for (const std::string& word : run.silent)
    if (o.text.find(word) != std::string::npos) missing.push_back(fmt::format("says \"{}\"", word));
  finding.what = refusal ? "refused" : "runs";
  finding.right = fmt::format(
      "exit code {}{}{}", fmt::join(run.exit, " or "),
      run.says.empty() ? "" : fmt::format(", \"{}\"", fmt::join(run.says, "\", \"")),
      run.silent.empty() ? "" : fmt::format(", not \"{}\"", fmt::join(run.silent, "\", \"")));
  finding.found = missing.empty() ? refusal ? first_lines(o.text) : ""
                                  : fmt::format("{}{}", fmt::join(missing, ", "),
                                                o.code ? ": " + first_lines(o.text) : "");
  finding.verdict = !missing.empty() ? Verdict::fail : refusal ? Verdict::refused : Verdict::pass;
  return finding;
}

const std::string limit = "timeout 600 ";

/// Interrupted in between and resumed from another folder, a run must leave the same bytes as in one go. How
/// long until the signal depends on the machine.
Outcome interrupted(const std::string& line, const std::string& folder, const Setting& setting) {
  const Outcome whole = shell(limit + line);
  if (whole.code != 0) return whole;
  fs::rename(folder, folder + "-whole");
  for (const char* after : {"1", "1.5", "2", "3", "5", "8", "0.5"}) {
    fs::remove_all(folder);
    const Outcome half = shell(fmt::format("timeout --preserve-status -s INT {} {}", after, line));
    if (half.code == 0 || half.code == 130) continue;  // through before the signal came, or not yet begun
    if (half.code != 6) return half;
    const Outcome rest = shell(
        fmt::format("cd / && timeout 600 {} resume {}", quoted(setting.program), quoted(folder)));
    if (rest.code == 0 && file_text(folder + "/history.csv") != file_text(folder + "-whole/history.csv"))
      return {-1, "another history than that of a run in one go"};
    return rest;
  }
  return {-1, "the run is too short to interrupt"};
}

}  // namespace

/// Whether every body that deforms is a mesh: FEM then takes no spacing.
bool all_meshes(const std::string& scene) {
  std::ostringstream whole;
  whole << std::ifstream(scene).rdbuf();
  const std::string text = whole.str();
  std::size_t bodies = 0, without = 0;
  for (std::size_t at = text.find("[bodies."); at != std::string::npos;
       at = text.find("[bodies.", at + 1), ++bodies) {
    const std::string table = text.substr(at, text.find("\n[", at) - at);
    without += table.find("\"mesh\"") == std::string::npos && table.find("rigid = true") == std::string::npos;
  }
  return bodies > 0 && without == 0;
}

std::vector<Finding> judge(const Run& run, const std::string& scene, const std::string& method,
                           const std::string& spacing, const std::string& name, const Setting& setting) {
  const std::string folder = fs::absolute(setting.out + "/" + name).string();
  std::vector<Finding> findings;
  try {
    fs::remove_all(folder);
    fs::remove_all(folder + "-whole");
    fs::create_directories(folder);
    std::string line = quoted(setting.program) + " " + run.command;
    const std::string file = scene.empty() ? "" : scene_file(run, scene, folder, setting);
    if (!scene.empty()) line += " " + quoted(file);
    if (!method.empty()) line += " --solver " + method;
    if (!spacing.empty() && !(method.starts_with("fem") && all_meshes(file)))
      line += " --spacing " + quoted(spacing);
    for (const std::string& word : run.options) line += " " + quoted(word);
    if (run.command == "run") line += " --no-fields --out " + quoted(folder);
    if (line.find("'--threads'") == std::string::npos &&
        (run.command == "run" || (run.command == "check" && !method.empty())))
      line += " --threads 1";
    Outcome o = run.interrupt ? interrupted(line, folder, setting) : shell(limit + line);
    const std::string here = fs::current_path().string() + "/";  // of no interest to whoever reads the table
    for (std::size_t at = o.text.find(here); at != std::string::npos; at = o.text.find(here))
      o.text.erase(at, here.size());
    std::ofstream(folder + ".log") << line << "\n" << o.text << "exit code " << o.code << "\n";
    findings.push_back(look_at_words(run, o));
    for (const Read& read : run.reads) {
      Finding finding{"", "", name_of(read), "", "", Verdict::fail};
      try {
        compare_read(read, folder, o.text, finding);
      } catch (const std::exception& error) {
        finding.found = o.code == 0 ? error.what() : "no run";
        if (read.value) finding.right = shown(read.value->number, read.value->unit);
      }
      findings.push_back(finding);
    }
  } catch (const std::exception& error) {
    findings.push_back({"", "", "the case itself", "", error.what(), Verdict::fail});
  }
  const bool failed = std::any_of(
      findings.begin(), findings.end(), [](const Finding& f) { return f.verdict == Verdict::fail; });
  for (Finding& finding : findings) {
    finding.scene = scene + (spacing.empty() ? "" : ", " + spacing);
    for (const std::string& word : run.options) finding.scene += " " + word;
    for (const auto& [from, to] : run.replace)
      if (from.size() < 20 && to.size() < 40) finding.scene += fmt::format(" {} = {}", from, to);
    finding.method = method;
    if (run.gap.empty()) continue;
    if (finding.verdict == Verdict::fail)
      finding.verdict = Verdict::gap, finding.found += "; " + run.gap;
    else if (!failed)
      finding.verdict = Verdict::closed;
  }
  return findings;
}

bool as_expected(const Finding& finding) {
  return finding.verdict != Verdict::fail && finding.verdict != Verdict::closed;
}

std::string word(Verdict verdict) {
  static const std::map<Verdict, std::string> words = {
      {Verdict::pass, "PASS"},
      {Verdict::refused, "refused as it must be"},
      {Verdict::fail, "FAIL"},
      {Verdict::gap, "GAP"},
      {Verdict::closed, "closed: take the mark \"gap\" away"}};
  return words.at(verdict);
}

}  // namespace femsph::field
