#pragma once
// Runs of the real program that are stopped from outside, and what two runs left compared to the byte.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/verification/interrupted_scenes.hpp"

namespace femsph::interrupted {

namespace fs = std::filesystem;
using testing::HasSubstr;

inline std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Starts the program with its output in `log`.
inline pid_t start(const std::string& arguments, const fs::path& log) {
  std::istringstream words(arguments);
  std::vector<std::string> list{FEMSPH_PROGRAM};
  for (std::string word; words >> word;) list.push_back(word);
  const pid_t child = fork();
  if (child != 0) return child;
  std::vector<char*> argv;
  for (std::string& word : list) argv.push_back(word.data());
  argv.push_back(nullptr);
  if (!freopen(log.c_str(), "w", stdout) || dup2(1, 2) < 0) _exit(99);
  execv(argv[0], argv.data());
  _exit(99);
}

/// Its exit code, or minus the signal that ended it.
inline int wait_for(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

inline int run(const std::string& arguments, const fs::path& log) { return wait_for(start(arguments, log)); }

/// Every file of a run by its name; the record without times, costs and the command.
inline std::map<std::string, std::string> results(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) all[fs::relative(entry.path(), folder)] = read(entry.path());
  std::istringstream record(all["record.toml"]);
  std::string kept;
  bool price = false;
  for (std::string line; std::getline(record, line);) {
    if (line.starts_with("["))
      price = line == "[price]";
    else if (line.find("[price") != std::string::npos)
      price = true;
    if (!price && !line.starts_with("command") && !line.starts_with("finished_at")) kept += line + "\n";
  }
  all["record.toml"] = kept;
  return all;
}

inline void expect_equal(const fs::path& one, const fs::path& other) {
  const auto a = results(one), b = results(other);
  ASSERT_GE(a.size(), 8u);
  for (const auto& [file, bytes] : a) {
    ASSERT_TRUE(b.contains(file)) << file << " is missing";
    EXPECT_TRUE(b.at(file) == bytes) << file << " differs";
  }
  EXPECT_EQ(a.size(), b.size());
}

class Interrupted : public testing::Test {
 protected:
  Interrupted() : folder(fs::temp_directory_path() / ("femsph-resume-" + std::to_string(getpid()))) {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~Interrupted() override { fs::remove_all(folder); }

  std::string scene_file(const Case& c) {
    const fs::path file = folder / (c.name + ".toml");
    std::ofstream(file) << c.scene;
    return file;
  }
  std::string run_of(const Case& c, const std::string& out) {
    return "run " + scene_file(c) + " --solver " + c.solver + " " + c.options + " --threads 2 --out " +
           (folder / out).string();
  }
  fs::path folder;
};

}  // namespace femsph::interrupted
