// Times of every kernel and effect, as ratios too. README.md in this folder says what the columns are;
// tests/bench/run writes it.
//   bench [--markdown FILE] [--quick]      the tables; other options go to Google Benchmark
//   bench --profile STEPS [--markdown FILE]   where the time of whole runs goes

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iostream>
#include <optional>

#include "model/results/history.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/report.hpp"

namespace {

using namespace femsph;
using namespace femsph::bench;

/// Keeps the medians for the tables, and prints as usual. A name is "section: case".
class Collector : public benchmark::ConsoleReporter {
 public:
  std::vector<Line> lines;
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& r : runs) {
      if (r.error_occurred || (r.run_type == Run::RT_Aggregate && r.aggregate_name != "median") ||
          (r.repetitions > 1 && r.run_type != Run::RT_Aggregate))
        continue;
      const std::string name = r.run_name.function_name;
      const std::size_t colon = name.find(": ");
      Line line{
          name.substr(0, colon), name.substr(colon + 2), r.real_accumulated_time / double(r.iterations), {}};
      for (const auto& [key, value] : r.counters) line.counters[key] = value;
      lines.push_back(line);
    }
  }
};

template <class F>
void add(const std::string& section, const std::string& name, bool quick, F&& run, int iterations = 40) {
  auto* b = benchmark::RegisterBenchmark((section + ": " + name).c_str(), std::forward<F>(run));
  b->Unit(benchmark::kMicrosecond)
      ->UseManualTime()
      ->Iterations(quick ? std::min(iterations, 20) : iterations);
  if (!quick) b->Repetitions(3)->ReportAggregatesOnly(true);
}

/// Takes the option and its value out of argv.
std::optional<std::string> option(int& argc, char** argv, const char* name, bool with_value) {
  for (int i = 1; i < argc; ++i)
    if (std::strcmp(argv[i], name) == 0) {
      const int width = with_value && i + 1 < argc ? 2 : 1;
      const std::string value = width == 2 ? argv[i + 1] : "";
      for (int k = i; k + width <= argc; ++k) argv[k] = argv[k + width];
      argc -= width;
      return value;
    }
  return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  const auto file = option(argc, argv, "--markdown", true), steps = option(argc, argv, "--profile", true);
  const bool quick = option(argc, argv, "--quick", false).has_value();
  std::string text;
  if (steps) {
    text = profile(std::stoi(*steps));
    fmt::print("{}", text);
  } else {
    benchmark::Initialize(&argc, argv);
    std::map<std::string, double> aims;
    std::map<std::string, std::string> without;
    add("triad", "triad, cached", quick, [](benchmark::State& s) { triad(s, 1000); });
    add("triad", "triad, large", quick, [](benchmark::State& s) { triad(s, 4000000); });
    for (const int dim : {2, 3}) {
      Case c{fmt::format("{}D FEValues", dim), dim, compare::method_named("fem-full")};
      c.units = dim == 2 ? 1e4 : 4e3;
      add("oracle", c.name, quick, [=](benchmark::State& s) { step(s, c, true); });
    }
    for (const Case& c : targets()) {
      aims[c.name] = c.target;
      add("target", c.name, quick, [=](benchmark::State& s) { step(s, c); });
      if (c.yield != Yield::tenth && !c.moving && !quick)
        add(
            "threads", c.name, true, [=](benchmark::State& s) { two_threads(s, c); }, 10);
    }
    if (!quick) {
      for (const Case& c : methods()) add("method", c.name, quick, [=](benchmark::State& s) { step(s, c); });
      for (const Case& c : bench::effects()) {
        if (!c.without.empty()) without[c.name] = c.without;
        add(
            "effect", c.name, quick, [=](benchmark::State& s) { march_step(s, c); }, 1);
      }
    }
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    text = markdown(collector.lines, aims, without);
  }
  if (file) write_text(text, *file);
  return 0;
}
