#pragma once
// Problems that users met, as data: one file in cases/ for each line of the table in README.md, which
// describes the format.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace femsph::field {

/// A number and its unit as they stand in the file: "2 mm"; a plain number has the unit "1".
struct Quantity {
  double number = 0;
  std::string unit = "1";
};

enum class Reduce { final, first, max, min, peak, mean, middle, swing, integral, frequency, stop };

/// A number that a run leaves, and what it has to be.
struct Read {
  std::vector<std::string> columns;  ///< of the table; several are added, "-name" is taken away
  std::string table = "history";     ///< or section_NAME
  std::string after;  ///< in their place: the first number behind these words in what the program prints
  Reduce reduce = Reduce::final;
  std::optional<std::array<double, 2>> window;  ///< s (m along a section)
  std::optional<Quantity> value, within, least, most;
  std::optional<double> percent;
  std::string why;  ///< how the value is known and where the tolerance comes from
};

struct Run {
  int line = 0;
  std::vector<std::string> scenes, methods, spacings;  ///< every combination is run
  std::vector<std::string> options;
  std::string command = "run";
  std::vector<std::pair<std::string, std::string>> replace;  ///< words of the scene file, in their order
  bool quick = false;
  bool interrupt = false;  ///< stop it half-way, resume it from another folder, and compare with a run in one
                           ///< go, byte by byte
  std::vector<int> exit{0};               ///< one of these
  std::vector<std::string> says, silent;  ///< what the program must print, and must not
  std::string gap;                        ///< why the right result is not expected yet
  std::vector<Read> reads;
};

/// One line of the table.
struct Row {
  std::string file, stem, number, title, source, wanted;
  std::vector<Run> runs;
};

/// Throws InputError with file:line:column of everything that is wrong.
Row read_row(const std::string& file);

enum class Verdict { pass, refused, fail, gap, closed };

/// One check of one run: a number, or (without one) exit code and messages.
struct Finding {
  std::string scene, method, what, right, found;
  Verdict verdict;
};

struct Setting {
  std::string program, scenes, out;
};

/// Runs one scene by one method and spacing (each may be empty), and judges it.
std::vector<Finding> judge(const Run& run, const std::string& scene, const std::string& method,
                           const std::string& spacing, const std::string& name, const Setting& setting);

struct Judged {
  const Row* row;
  std::vector<Finding> findings;
};
bool as_expected(const Finding& finding);
std::string word(Verdict verdict);
/// The table of the rows, and under it that of every check.
std::string markdown(const std::vector<Judged>& all);

}  // namespace femsph::field
