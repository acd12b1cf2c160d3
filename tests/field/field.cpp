// Runs the cases and judges them: `field [--quick] [--jobs N] [--out DIR] [--readme FILE] CASE.toml ..`. Exit
// code 0: every verdict is as expected; 1: one is not, or a file of cases is wrong; 77: nothing to do.

#include <fmt/format.h>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <thread>

#include "compare/report/readme.hpp"
#include "tests/field/case.hpp"

namespace {

using namespace femsph::field;

struct Job {
  std::size_t row;
  const Run* run;
  std::string scene, method, spacing, name;
  std::vector<Finding> findings;
};

std::vector<Job> jobs_of(const std::vector<Row>& rows, bool quick) {
  std::vector<Job> jobs;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const Run& run : rows[r].runs)
      if (!quick || run.quick)
        for (const std::string& scene : run.scenes)
          for (const std::string& method : run.methods)
            for (const std::string& spacing : run.spacings)
              jobs.push_back(
                  {r, &run, scene, method, spacing, fmt::format("{}/{}", rows[r].stem, jobs.size()), {}});
  return jobs;
}

void work(std::vector<Job>& jobs, int threads, const Setting& setting) {
  std::atomic<std::size_t> next = 0;
  const auto worker = [&] {
    for (std::size_t i; (i = next++) < jobs.size();) {
      Job& job = jobs[i];
      job.findings = judge(*job.run, job.scene, job.method, job.spacing, job.name, setting);
    }
  };
  std::vector<std::thread> pool;
  for (int t = 0; t < threads; ++t) pool.emplace_back(worker);
  for (std::thread& thread : pool) thread.join();
}

void write_readme(const std::string& file, const std::string& table) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  const std::string with = femsph::compare::with_table(text.str(), table);
  std::ofstream(file) << with;
}

int judge_all(const std::vector<std::string>& files, bool quick, int threads, const Setting& setting,
              const std::string& readme) {
  std::vector<Row> rows;
  for (const std::string& file : files) rows.push_back(read_row(file));
  std::vector<Job> jobs = jobs_of(rows, quick);
  if (jobs.empty()) return 77;
  work(jobs, threads, setting);
  std::vector<Judged> all;
  int unexpected = 0;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    Judged judged{&rows[r], {}};
    for (const Job& job : jobs)
      if (job.row == r)
        judged.findings.insert(judged.findings.end(), job.findings.begin(), job.findings.end());
    if (judged.findings.empty()) continue;
    for (const Job& job : jobs)
      for (const Finding& f : job.findings)
        if (job.row == r && !as_expected(f))
          ++unexpected, fmt::print("{}:{}: {} {}: {}: right {}; found {}; {} (log: {}/{}.log)\n",
                                   rows[r].file, job.run->line, f.scene, f.method, f.what, f.right, f.found,
                                   word(f.verdict), setting.out, job.name);
    all.push_back(std::move(judged));
  }
  const std::string table = markdown(all);
  std::ofstream(setting.out + "/table.md") << table;
  if (!readme.empty()) write_readme(readme, table);
  if (files.size() > 1)
    std::cout << table.substr(0, table.find("\n### ")) << "\nevery check: " << setting.out << "/table.md\n";
  if (unexpected) fmt::print("{} checks are not as expected\n", unexpected);
  return unexpected ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  bool quick = false;
  int threads = 1;
  std::string readme;
  Setting setting{FEMSPH_PROGRAM, std::string(FEMSPH_SOURCE_DIR) + "/tests/field/scenes", "results/field"};
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? argv[++i] : ""; };
    if (word == "--quick")
      quick = true;
    else if (word == "--jobs")
      threads = std::max(1, std::atoi(value()));
    else if (word == "--out")
      setting.out = value();
    else if (word == "--readme")
      readme = value();
    else
      files.push_back(word);
  }
  try {
    std::filesystem::create_directories(setting.out);
    return judge_all(files, quick, threads, setting, readme);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
