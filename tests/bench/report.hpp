#pragma once
// The tables of tests/bench/README.md.

#include <map>
#include <string>
#include <vector>

namespace femsph::bench {

/// One measured case: what Google Benchmark gives as its median.
struct Line {
  std::string section, name;
  double seconds;  ///< of a step, all units
  std::map<std::string, double> counters;
};

/// `targets`: name -> ns a unit and step; `without`: effect -> the case that lacks it.
std::string markdown(const std::vector<Line>& lines, const std::map<std::string, double>& targets,
                     const std::map<std::string, std::string>& without);

/// Where the wall time of whole runs goes: 10 000 steps of about 1e5 units with output, a run a method.
std::string profile(int steps);

}  // namespace femsph::bench
