// Runs the program as a user would, and looks at what it prints and leaves.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include "compare/measure/errors.hpp"
#include "model/input/units.hpp"
#include "tests/field/case.hpp"

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

std::string file_text(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("the run left no " + fs::path(file).filename().string());
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

struct Column {
  std::string unit;
  std::vector<double> values;
};

/// A table that the program wrote: "name [unit]" above, then numbers.
std::map<std::string, Column> read_csv(const std::string& file) {
  std::istringstream in(file_text(file));
  std::map<std::string, Column> table;
  std::vector<Column*> order;
  std::string line, cell;
  std::getline(in, line);
  for (std::istringstream head(line); std::getline(head, cell, ',');) {
    const auto open = cell.rfind(" [");
    Column& column = table[cell.substr(0, open)];
    column.unit = cell.substr(open + 2, cell.size() - open - 3);
    order.push_back(&column);
  }
  while (std::getline(in, line)) {
    std::size_t c = 0;
    for (std::istringstream row(line); c < order.size() && std::getline(row, cell, ',');)
      order[c++]->values.push_back(std::strtod(cell.c_str(), nullptr));
  }
  return table;
}

/// In SI; UDUNITS-2 is not for several threads.
double si(const Quantity& quantity, const std::string& unit) {
  static std::mutex mutex;
  if (quantity.unit == "1") return quantity.number;
  const std::lock_guard lock(mutex);
  return quantity.number * to_si("1 " + quantity.unit, Dimension{unit.c_str(), "a quantity", unit.c_str()});
}

double integral(const std::vector<double>& at, const std::vector<double>& v) {
  double sum = 0;
  for (std::size_t i = 1; i < at.size(); ++i) sum += (at[i] - at[i - 1]) * (v[i] + v[i - 1]) / 2;
  return sum;
}

/// One number of a history; `stop`: when it last was more than 1e-3 of its range away from where it ends.
double reduced(Reduce reduce, const std::vector<double>& at, const std::vector<double>& v) {
  const auto [low, high] = std::minmax_element(v.begin(), v.end());
  switch (reduce) {
    case Reduce::final:
      return v.back();
    case Reduce::first:
      return v.front();
    case Reduce::max:
      return *high;
    case Reduce::min:
      return *low;
    case Reduce::peak:
      return std::abs(*low) > std::abs(*high) ? *low : *high;
    case Reduce::mean:
      return integral(at, v) / (at.back() - at.front());
    case Reduce::middle:
      return (*low + *high) / 2;
    case Reduce::swing:
      return (*high - *low) / 2;
    case Reduce::integral:
      return integral(at, v);
    case Reduce::frequency:
      if (const auto f = compare::dominant_frequency(at, v)) return *f;
      throw std::runtime_error("the history does not swing back, so it has no frequency");
    case Reduce::stop:
      for (std::size_t i = v.size(); i-- > 0;)
        if (std::abs(v[i] - v.back()) > 1e-3 * (*high - *low)) return at[i];
      return at.front();
  }
  return NAN;
}

std::pair<double, std::string> number_of(const Read& read, const std::string& folder,
                                         const std::string& printed) {
  if (!read.after.empty()) {
    const auto at = printed.find(read.after);
    if (at == std::string::npos) throw std::runtime_error(fmt::format("\"{}\" is not printed", read.after));
    const auto digit = printed.find_first_of("0123456789-", at + read.after.size());
    if (digit == std::string::npos)
      throw std::runtime_error(fmt::format("no number is printed behind \"{}\"", read.after));
    return {std::strtod(printed.c_str() + digit, nullptr), "1"};
  }
  const auto table = read_csv(folder + "/" + read.table + ".csv");
  const std::vector<double>& place = table.at(read.table == "history" ? "time" : "distance").values;
  std::vector<double> at, v;
  std::string unit;
  for (std::size_t i = 0; i < place.size(); ++i)
    if (!read.window || (place[i] >= (*read.window)[0] && place[i] <= (*read.window)[1]))
      at.push_back(place[i]), v.push_back(0);
  for (const std::string& term : read.columns) {
    const double sign = term.starts_with("-") ? -1 : 1;
    const std::string name = term.substr(sign < 0);
    const auto found = table.find(name);
    if (found == table.end())
      throw std::runtime_error(fmt::format("{}.csv has no column {}", read.table, name));
    unit = found->second.unit;
    for (std::size_t i = 0, k = 0; i < place.size(); ++i)
      if (!read.window || (place[i] >= (*read.window)[0] && place[i] <= (*read.window)[1]))
        v[k++] += sign * found->second.values.at(i);
  }
  if (v.empty()) throw std::runtime_error("no sample lies in the window");
  if (read.reduce == Reduce::integral) unit += " s";
  if (read.reduce == Reduce::frequency) unit = "Hz";
  if (read.reduce == Reduce::stop) unit = "s";
  return {reduced(read.reduce, at, v), unit};
}

std::string shown(double number) { return fmt::format("{:.5g}", number); }
std::string shown(double number, const std::string& unit) {
  return unit == "1" ? shown(number) : shown(number) + " " + unit;
}

/// Compares in the unit in which the right value is given.
void compare_read(const Read& read, const std::string& folder, const std::string& printed, Finding& finding) {
  const auto [number, unit] = number_of(read, folder, printed);
  const Quantity& main = read.value ? *read.value : read.least ? *read.least : *read.most;
  const double found = number / si({1, main.unit}, unit);
  bool good = std::isfinite(found);
  finding.found = shown(found, main.unit);
  if (read.value) {
    const double right = read.value->number;
    const double band = read.percent ? std::abs(right) * *read.percent / 100
                                     : si(*read.within, unit) / si({1, main.unit}, unit);
    good = good && std::abs(found - right) <= band;
    finding.right = fmt::format(
        "{} +- {}", shown(right, main.unit),
        read.percent ? fmt::format("{:g} %", *read.percent) : shown(read.within->number, read.within->unit));
    if (right != 0) finding.found += fmt::format(" ({:+.2g} %)", 100 * (found / right - 1));
  }
  if (read.least)
    good = good && number >= si(*read.least, unit),
    finding.right += (finding.right.empty() ? "" : ", ") +
                     ("at least " + shown(read.least->number, read.least->unit));
  if (read.most)
    good = good && number <= si(*read.most, unit),
    finding.right += (finding.right.empty() ? "" : ", ") +
                     ("at most " + shown(read.most->number, read.most->unit));
  finding.verdict = good ? Verdict::pass : Verdict::fail;
}

const char* const names[] = {
    "final", "first", "max", "min", "peak", "mean", "middle", "swing", "integral", "frequency", "stop"};

std::string name_of(const Read& read) {
  if (!read.after.empty()) return "\"" + read.after + "\"";
  return fmt::format("{} {}{}", names[int(read.reduce)], read.table == "history" ? "" : read.table + ": ",
                     fmt::join(read.columns, " + "));
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

/// On the way an interruption, then on from another folder: the same bytes as in one go. When the way is
/// depends on the machine.
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

/// Every body of the scene that deforms brings its cells: FEM takes no spacing there.
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
  switch (verdict) {
    case Verdict::pass:
      return "PASS";
    case Verdict::refused:
      return "refused as it must be";
    case Verdict::fail:
      return "FAIL";
    case Verdict::gap:
      return "GAP";
    case Verdict::closed:
      return "closed: take the mark \"gap\" away";
  }
  return "";
}

}  // namespace femsph::field
