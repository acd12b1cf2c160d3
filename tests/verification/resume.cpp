// Runs of the program are killed at random times and resumed: their files must be those of an undisturbed
// run, byte for byte.
//   FEMSPH_KILLS=20 build/release/verification --gtest_filter='Resume.*'     tries as often for every scene
//   and method (else once, by one signal or the other)

#include <random>

#include "tests/verification/interrupted.hpp"

namespace femsph::interrupted {
namespace {

class Resume : public Interrupted {};

TEST_F(Resume, AKilledRunEndsAsAnUndisturbedOne) {
  const char* asked = std::getenv("FEMSPH_KILLS");
  const int kills = asked ? std::atoi(asked) : 1;
  std::mt19937 random(asked ? std::random_device{}() : 1);
  int taken_up = 0, early = 0, tried = 0;
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name + " by " + c.solver);
    ASSERT_EQ(run(run_of(c, "whole"), folder / "log"), 0) << read(folder / "log");
    ASSERT_FALSE(fs::exists(folder / "whole/checkpoint.h5"));
    for (int k = 0; k < kills; ++k) {
      const int signal = tried++ % 2 == 0 ? SIGKILL : SIGTERM;
      fs::remove_all(folder / "cut");
      const pid_t child = start(run_of(c, "cut") + " --checkpoint 40", folder / "log");
      int status = 0;
      while (!fs::exists(folder / "cut/checkpoint.h5") && waitpid(child, &status, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::this_thread::sleep_for(
          std::chrono::microseconds(std::uniform_int_distribution<int>(0, 150000)(random)));
      kill(child, signal);
      const int code = wait_for(child);
      if (code == 0 || (code == -signal &&
                        !fs::exists(folder / "cut/checkpoint.h5"))) {  // it ended before the signal: all is
                                                                       // written, and the checkpoint removed
        ++early;
        expect_equal(folder / "whole", folder / "cut");
        continue;
      }
      ASSERT_EQ(code, signal == SIGKILL ? -SIGKILL : 6) << read(folder / "log");
      if (signal == SIGTERM) {
        EXPECT_THAT(read(folder / "log"), HasSubstr("interrupted at step"));
      }
      ASSERT_TRUE(fs::exists(folder / "cut/checkpoint.h5"));
      ASSERT_EQ(run("resume " + (folder / "cut").string() + " --threads 1", folder / "log"), 0)
          << read(folder / "log");
      for (const auto& entry :
           fs::recursive_directory_iterator(folder / "cut"))  // what a SIGKILL in mid-write leaves
        if (entry.path().extension() == ".part") fs::remove(entry.path());
      expect_equal(folder / "whole", folder / "cut");
      ++taken_up;
    }
    fs::remove_all(folder / "whole");
  }
  std::printf("%d runs killed and taken up, %d that had ended before\n", taken_up, early);
  EXPECT_GT(taken_up, 0);
}

}  // namespace
}  // namespace femsph::interrupted
