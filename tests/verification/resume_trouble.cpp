// Trouble with checkpoints: repeated interruptions, damaged files, files of another program, a full disk.

#include <sys/resource.h>

#include "tests/verification/interrupted.hpp"

namespace femsph::interrupted {
namespace {

class ResumeTrouble : public Interrupted {};

TEST_F(ResumeTrouble, SeveralInterruptionsInOneRun) {
  const Case& c = case_named("impact", "sph-corrected");
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
TEST_F(ResumeTrouble, DamagedAndForeignCheckpointsAreOneMessage) {
  const Case& c = case_named("impact", "fem-full");
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
  const std::string other = (folder / "other").string() + " " + resume,
                    log = " > " + (folder / "log").string() + " 2>&1";
  EXPECT_EQ(WEXITSTATUS(std::system((other + log).c_str())), 1);
  EXPECT_THAT(read(folder / "log"), HasSubstr("was written by femsph"));
  EXPECT_EQ(WEXITSTATUS(std::system((other + " --any-program" + log).c_str())), 0) << read(folder / "log");
}

/// A disk that is full when a later checkpoint is written: the one before stays whole, and the run goes on
/// from it.
TEST_F(ResumeTrouble, AFullDiskLosesNothing) {
  const Case& c = case_named("impact", "sph-corrected");
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
}  // namespace femsph::interrupted
