// Runs of the real program are killed at random moments and taken up again: what they leave must be what an undisturbed run leaves, to the byte.
//   FEMSPH_KILLS=20 build/release/verification --gtest_filter='Resume.*'     tries as often for every scene and method (else once, by one signal or the other)

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <regex>
#include <sstream>
#include <thread>

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const char* const blow = R"(
[model]
plane = "stress"
motion = "large"
[materials.steel]
law = "plastic"
young = "210 GPa"
poisson = 0.3
density = "7850 kg/m^3"
yield = "300 MPa"
tangent_ratio = 0.01
[bodies.A]
shape = "box"
origin = ["50 mm", "100 mm"]
size = ["100 mm", "50 mm"]
thickness = "100 mm"
material = "steel"
[bodies.B]
shape = "box"
size = ["200 mm", "100 mm"]
thickness = "100 mm"
material = "steel"
[bodies.weight]
shape = "disc"
centre = ["20 mm", "150.1 mm"]
radius = "50 mm"
rigid = true
mass = "30 kg"
[[supports]]
body = "B"
at = "y-"
fix = ["x", "y"]
[[contacts]]
between = ["A", "B"]
friction = 0.3
[[contacts]]
between = ["weight", "B"]
friction = 0.1
[[initial]]
body = "A"
velocity = ["20 m/s", "-40 m/s"]
[[initial]]
body = "weight"
velocity = ["0 m/s", "-10 m/s"]
[[probes]]
name = "A"
body = "A"
quantity = "displacement"
point = ["100 mm", "150 mm"]
[[sections]]
name = "middle"
body = "B"
quantity = "stress"
from = ["100 mm", "0 mm"]
to = ["100 mm", "100 mm"]
[time]
duration = "1.5 ms"
samples = 50
snapshots = 5
)";

const char* const settling = R"(
[model]
plane = "stress"
[materials.concrete]
law = "plastic"
young = "23.3 GPa"
poisson = 0.2
density = "2400 kg/m^3"
yield = "30 MPa"
tangent_ratio = 0.01
[materials.bar]
law = "plastic"
young = "206 GPa"
poisson = 0.3
density = "7850 kg/m^3"
yield = "20 MPa"
tangent_ratio = 0.01
[bodies.beam]
shape = "box"
size = ["400 mm", "50 mm"]
thickness = "50 mm"
material = "concrete"
[bars.bottom]
body = "beam"
from = ["0 mm", "12 mm"]
to = ["400 mm", "12 mm"]
area = "100 mm^2"
material = "bar"
[[supports]]
at = "x-"
fix = ["x", "y"]
[[loads]]
at = "x+"
force = ["0 N", "-1.2 kN"]
[[probes]]
name = "tip"
quantity = "displacement"
point = ["400 mm", "25 mm"]
[settling]
method = "METHOD"
[time]
duration = "60 ms"
samples = 50
snapshots = 5
)";

const char* const solid = R"(
[model]
plane = "none"
motion = "large"
[materials.steel]
law = "plastic"
young = "210 GPa"
poisson = 0.3
density = "7850 kg/m^3"
yield = "300 MPa"
tangent_ratio = 0.01
[bodies.bar]
shape = "box"
size = ["60 mm", "20 mm", "20 mm"]
material = "steel"
[[supports]]
at = "x-"
fix = ["x", "y", "z"]
[[initial]]
body = "bar"
velocity = ["0 m/s", "-40 m/s", "15 m/s"]
[[probes]]
name = "end"
quantity = "displacement"
point = ["60 mm", "20 mm", "20 mm"]
[time]
duration = "0.8 ms"
samples = 50
snapshots = 5
)";

struct Case {
  const char *name, *scene, *solver, *options;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"blow", blow, "fem-full", "--spacing 5mm"},
      {"blow", blow, "fem-sri", "--spacing 5mm"},
      {"blow", blow, "fem-one-point", "--spacing 5mm"},
      {"blow", blow, "fem-assumed-strain", "--spacing 5mm"},
      {"blow", blow, "sph-corrected", "--spacing 5mm"},
      {"blow", blow, "sph-classic-share", "--spacing 5mm --viscosity 1,1,0.01"},
      {"damped", settling, "fem-full", "--spacing 12.5mm"},
      {"damped", settling, "sph-classic-share", "--spacing 12.5mm --viscosity 1,1,0.01"},
      {"damped", settling, "sph-virtual", "--spacing 12.5mm"},
      {"damped", settling, "sph-weight", "--spacing 12.5mm"},
      {"kinetic", settling, "sph-corrected", "--spacing 12.5mm"},
      {"solid", solid, "fem-full", "--spacing 5mm"},
      {"solid", solid, "fem-assumed-strain", "--spacing 5mm"},
      {"solid", solid, "sph-corrected", "--spacing 5mm"},
      {"solid", solid, "sph-classic-full", "--spacing 5mm"},
  };
  return all;
}

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Starts the program with its output in `log`.
pid_t start(const std::string& arguments, const fs::path& log) {
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
int wait_for(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

int run(const std::string& arguments, const fs::path& log) { return wait_for(start(arguments, log)); }

/// Every file of a run by its name; of the record only what does not speak of time, price and command.
std::map<std::string, std::string> results(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) all[fs::relative(entry.path(), folder)] = read(entry.path());
  std::istringstream record(all["record.toml"]);
  std::string kept;
  bool price = false;
  for (std::string line; std::getline(record, line);) {
    if (line.starts_with("[")) price = line == "[price]";
    else if (line.find("[price") != std::string::npos) price = true;
    if (!price && !line.starts_with("command") && !line.starts_with("finished_at")) kept += line + "\n";
  }
  all["record.toml"] = kept;
  return all;
}

void expect_equal(const fs::path& one, const fs::path& other) {
  const auto a = results(one), b = results(other);
  ASSERT_GE(a.size(), 8u);
  for (const auto& [file, bytes] : a) {
    ASSERT_TRUE(b.contains(file)) << file << " is missing";
    EXPECT_TRUE(b.at(file) == bytes) << file << " differs";
  }
  EXPECT_EQ(a.size(), b.size());
}

class Resume : public testing::Test {
 protected:
  Resume() : folder(fs::temp_directory_path() / ("femsph-resume-" + std::to_string(getpid()))) {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~Resume() override { fs::remove_all(folder); }

  std::string scene_file(const Case& c) {
    const fs::path file = folder / (std::string(c.name) + ".toml");
    const std::string method = std::string(c.name) == "kinetic" ? "kinetic" : "damping";
    std::ofstream(file) << std::regex_replace(c.scene, std::regex("METHOD"), method);
    return file;
  }
  std::string run_of(const Case& c, const std::string& out) {
    return "run " + scene_file(c) + " --solver " + c.solver + " " + c.options + " --threads 2 --out " + (folder / out).string();
  }
  fs::path folder;
};

TEST_F(Resume, ARunThatWasKilledGoesOnAsIfNothingHadBeen) {
  const char* asked = std::getenv("FEMSPH_KILLS");
  const int kills = asked ? std::atoi(asked) : 1;
  std::mt19937 random(asked ? std::random_device{}() : 1);
  int taken_up = 0, early = 0, tried = 0;
  for (const Case& c : cases()) {
    SCOPED_TRACE(std::string(c.name) + " by " + c.solver);
    ASSERT_EQ(run(run_of(c, "whole"), folder / "log"), 0) << read(folder / "log");
    ASSERT_FALSE(fs::exists(folder / "whole/checkpoint.h5"));
    for (int k = 0; k < kills; ++k) {
      const int signal = tried++ % 2 == 0 ? SIGKILL : SIGTERM;
      fs::remove_all(folder / "cut");
      const pid_t child = start(run_of(c, "cut") + " --checkpoint 40", folder / "log");
      int status = 0;
      while (!fs::exists(folder / "cut/checkpoint.h5") && waitpid(child, &status, WNOHANG) == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::this_thread::sleep_for(std::chrono::microseconds(std::uniform_int_distribution<int>(0, 150000)(random)));
      kill(child, signal);
      const int code = wait_for(child);
      if (code == 0 || (code == -signal && !fs::exists(folder / "cut/checkpoint.h5"))) {  // it was faster: all is written, and the checkpoint gone
        ++early;
        expect_equal(folder / "whole", folder / "cut");
        continue;
      }
      ASSERT_EQ(code, signal == SIGKILL ? -SIGKILL : 6) << read(folder / "log");
      if (signal == SIGTERM) {
        EXPECT_THAT(read(folder / "log"), HasSubstr("interrupted at step"));
      }
      ASSERT_TRUE(fs::exists(folder / "cut/checkpoint.h5"));
      ASSERT_EQ(run("resume " + (folder / "cut").string() + " --threads 1", folder / "log"), 0) << read(folder / "log");
      for (const auto& entry : fs::recursive_directory_iterator(folder / "cut"))  // what a SIGKILL in mid-write leaves
        if (entry.path().extension() == ".part") fs::remove(entry.path());
      expect_equal(folder / "whole", folder / "cut");
      ++taken_up;
    }
    fs::remove_all(folder / "whole");
  }
  std::printf("%d runs killed and taken up, %d that had ended before\n", taken_up, early);
  EXPECT_GT(taken_up, 0);
}

TEST_F(Resume, SeveralInterruptionsInOneRun) {
  const Case& c = cases()[4];
  ASSERT_EQ(run(run_of(c, "whole"), folder / "log"), 0);
  const pid_t child = start(run_of(c, "cut") + " --checkpoint 10", folder / "log");
  while (!fs::exists(folder / "cut/checkpoint.h5")) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, SIGINT);
  int code = wait_for(child), times = 0;
  for (; code != 0 && times < 5; ++times) {
    ASSERT_EQ(code, 6) << read(folder / "log");
    const pid_t again = start("resume " + (folder / "cut").string(), folder / "log");
    std::this_thread::sleep_for(std::chrono::milliseconds(30 + 20 * times));
    kill(again, SIGTERM);
    code = wait_for(again);
    if (code == -SIGTERM) code = 6;  // it had not begun to march
  }
  if (code != 0) {
    ASSERT_EQ(run("resume " + (folder / "cut").string(), folder / "log"), 0) << read(folder / "log");
  }
  expect_equal(folder / "whole", folder / "cut");
}

/// An interrupted run to spoil the checkpoint of.
TEST_F(Resume, DamagedAndForeignCheckpointsAreOneMessage) {
  const Case& c = cases()[0];
  const pid_t child = start(run_of(c, "cut") + " --checkpoint 10", folder / "log");
  while (!fs::exists(folder / "cut/checkpoint.h5")) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, SIGKILL);
  ASSERT_EQ(wait_for(child), -SIGKILL);
  const fs::path file = folder / "cut/checkpoint.h5";
  const std::string whole = read(file), resume = "resume " + (folder / "cut").string();
  const auto refused = [&](const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    EXPECT_EQ(run(resume, folder / "log"), 1);
    const std::string said = read(folder / "log");
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_THAT(said, HasSubstr("checkpoint.h5: "));
    return said;
  };
  EXPECT_THAT(refused(whole.substr(0, whole.size() / 2)), HasSubstr("cut short or damaged"));
  EXPECT_THAT(refused(whole.substr(0, whole.size() - 1)), HasSubstr("cut short or damaged"));
  EXPECT_THAT(refused(""), HasSubstr("cut short or damaged"));
  std::string flipped = whole;
  flipped[whole.size() / 3] ^= 1;
  EXPECT_THAT(refused(flipped), HasSubstr("cut short or damaged"));
  fs::remove(file);
  EXPECT_EQ(run(resume, folder / "log"), 1);
  EXPECT_THAT(read(folder / "log"), HasSubstr("no checkpoint can be read there"));
  // Another program: the same with one byte more behind its end.
  std::ofstream(file, std::ios::binary) << whole;
  fs::copy_file(FEMSPH_PROGRAM, folder / "other");
  std::ofstream(folder / "other", std::ios::binary | std::ios::app) << '\0';
  const std::string other = (folder / "other").string() + " " + resume, log = " > " + (folder / "log").string() + " 2>&1";
  EXPECT_EQ(WEXITSTATUS(std::system((other + log).c_str())), 1);
  EXPECT_THAT(read(folder / "log"), HasSubstr("was written by femsph"));
  EXPECT_EQ(WEXITSTATUS(std::system((other + " --any-program" + log).c_str())), 0) << read(folder / "log");
}

/// A disk that is full when a later checkpoint is written: the one before stays whole, and the run goes on from it.
TEST_F(Resume, AFullDiskLosesNothing) {
  const Case& c = cases()[4];
  ASSERT_EQ(run(run_of(c, "whole"), folder / "log"), 0);
  const pid_t child = start(run_of(c, "cut") + " --checkpoint 40", folder / "log");
  while (!fs::exists(folder / "cut/checkpoint.h5")) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const rlimit full{1000, RLIM_INFINITY};
  prlimit(child, RLIMIT_FSIZE, &full, nullptr);
  EXPECT_EQ(wait_for(child), 4);
  const std::string said = read(folder / "log");
  EXPECT_THAT(said, HasSubstr("cannot write"));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  ASSERT_EQ(run("resume " + (folder / "cut").string(), folder / "log"), 0) << read(folder / "log");
  expect_equal(folder / "whole", folder / "cut");
}

}  // namespace
