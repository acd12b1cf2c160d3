// The program as a user meets it: exit codes, messages, and what a run leaves behind.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "program_output.hpp"

namespace {

namespace fs = std::filesystem;
using femsph::test::Outcome;
using femsph::test::run_femsph;
using testing::HasSubstr;

const std::string scene = std::string(FEMSPH_SOURCE_DIR) + "/studies/fem-mesh/scene.toml";

struct Folder {
  fs::path path = fs::temp_directory_path() / ("femsph-test-" + std::to_string(getpid()));
  Folder() { fs::remove_all(path); }
  ~Folder() { fs::remove_all(path); }
};

TEST(Program, EveryBadSceneEndsWithOneMessageAndItsExitCode) {
  int files = 0;
  for (const auto& entry : fs::directory_iterator(std::string(FEMSPH_SOURCE_DIR) + "/tests/scenes/bad")) {
    const Outcome o = run_femsph("check " + entry.path().string());
    EXPECT_EQ(o.code, 1) << entry.path() << "\n" << o.text;
    EXPECT_THAT(o.text, HasSubstr(entry.path().filename().string() + ":"));
    ++files;
  }
  EXPECT_GE(files, 10);
}

TEST(Program, MissingSceneAndWrongOptionsAreExplained) {
  EXPECT_THAT(run_femsph("check no-such-scene.toml").text, HasSubstr("no-such-scene.toml"));
  EXPECT_EQ(run_femsph("check no-such-scene.toml").code, 1);
  EXPECT_THAT(run_femsph("run " + scene + " --solver fem-ful --spacing '10 mm' --out x").text,
              HasSubstr("did you mean \"fem-full\"?"));
  EXPECT_THAT(
      run_femsph("run " + scene + " --solver fem --spacing '10 N' --out x").text, HasSubstr("a length"));
  EXPECT_THAT(run_femsph("run " + scene + " --solver fem --out x").text, HasSubstr("no resolution is given"));
  EXPECT_THAT(run_femsph("run " + scene + " --solver fem --spacing '10 mm' --smoothing 1.2 --out x").text,
              HasSubstr("an option of SPH"));
  EXPECT_EQ(run_femsph("").code, 2);
  EXPECT_EQ(run_femsph("--version").code, 0);
  EXPECT_THAT(run_femsph("--version").text, HasSubstr("compiler"));
  EXPECT_EQ(run_femsph("list").code, 0);
  EXPECT_THAT(run_femsph("list").text, HasSubstr("sph-corrected"));
}

TEST(Program, CheckPrintsWhatFollowsFromTheScene) {
  const Outcome o = run_femsph("check " + scene + " --solver sph --spacing '10 mm'");
  EXPECT_EQ(o.code, 0) << o.text;
  for (const char* word : {"1111", "critical step", "memory", "effects on", "effects off"})
    EXPECT_THAT(o.text, HasSubstr(word));
}

TEST(Program, ARunLeavesHistoriesFieldsAndItsRecord) {
  const Folder out;
  for (const char* solver : {"fem", "sph"}) {
    const Outcome o = run_femsph(
        "run " + scene + " --solver " + solver + " --spacing '20 mm' --out " + (out.path / solver).string());
    ASSERT_EQ(o.code, 0) << o.text;
    for (const char* file : {"history.csv", "history.h5", "fields.xdmf", "record.toml", "scene.toml"})
      EXPECT_TRUE(fs::exists(out.path / solver / file)) << file;
    for (const auto& entry : fs::recursive_directory_iterator(out.path))
      EXPECT_THAT(entry.path().extension().string(), testing::Ne(".part"));
  }
}

TEST(Program, AdviceIsAskedForWithOneOfTwoOptions) {
  EXPECT_EQ(run_femsph("advise " + scene).code, 2);
  EXPECT_THAT(run_femsph("advise " + scene).text,
              HasSubstr("expected either an error, such as --error 1%, or a time"));
  EXPECT_EQ(run_femsph("advise " + scene + " --error 1 --within '1 s'").code, 2);
  EXPECT_EQ(run_femsph("advise no-such-scene.toml --error 1%").code, 1);
  const Outcome none = run_femsph("advise " + scene + " --error 1% --methods fem-full --budget '0.2 s'");
  EXPECT_EQ(none.code, 3);  // one method alone cannot be confirmed
  EXPECT_THAT(none.text, HasSubstr("no two methods"));
}

TEST(Program, AnUnwritableFolderIsOneMessage) {
  const Outcome o = run_femsph("run " + scene + " --solver fem --spacing '20 mm' --out " + scene + "/inside");
  EXPECT_EQ(o.code, 4);
  EXPECT_THAT(o.text, HasSubstr("cannot create the folder"));
}

}  // namespace
