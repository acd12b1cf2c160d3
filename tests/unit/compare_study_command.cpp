// A study from its files to its results, with a fake solver.

#include <gmock/gmock.h>

#include "compare/program/commands.hpp"
#include "compare/study/study_runner.hpp"
#include "compare_support.hpp"

namespace femsph::compare {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using namespace test;

const std::string command_study = R"(title = "A study"
[[runs]]
methods = ["fem-full"]
spacing = ["20 mm", "10 mm"]
quick = ["d=20mm"]
)" + tip_quantity("tip", cantilever_tip) +
                                  R"([[series]]
file = "error.csv"
kind = "error"
quantity = "tip"
[[claims]]
id = "fine"
source = "fig 1"
text = "10 mm are fine enough"
kind = "below"
rows = {cases = ["d=10mm"], quantity = "tip"}
bound = 1.5
)";

class StudyCommandTest : public ::testing::Test {
 protected:
  Folder folder{"command"};
  StudyCommand command;
  Engine engine;

  void SetUp() override {
    folder.write("studies/beam/scene.toml", cantilever_toml);
    folder.write("studies/beam/study.toml", command_study);
    folder.write("studies/beam/README.md", "# Beam\n\n<!-- femsph:table -->\n<!-- /femsph:table -->\n");
    command.name = folder / "studies/beam";
    command.out = folder / "results";
    engine.run = [](const Scene&, const BodyMethods&, const Resolution& resolution, const RunOptions&) {
      return result(-25e3 / (3 * 2.1e11 * 1e-4 / 12) * (1 + resolution.spacing), 1, resolution.spacing);
    };
  }
};

TEST_F(StudyCommandTest, WritesTablesDataAndClaims) {
  EXPECT_EQ(study_command(command, engine), 0);
  EXPECT_THAT(folder.read("results/beam/table.csv"),
              HasSubstr("beam,d=10mm,fem-full,10,10,tip,-4.80952381,mm,-4.761904762,1,"));
  EXPECT_THAT(folder.read("results/beam/orders.csv"), HasSubstr("beam,fem-full,tip,theory,20 10,1,1,,mm"));
  EXPECT_EQ(folder.read("results/beam/data/error.csv"), "spacing_mm,fem-full\r\n20,2\r\n10,1\r\n");
  EXPECT_THAT(folder.read("results/beam/claims.csv"),
              HasSubstr("fine,fig 1,10 mm are fine enough,below 1.5 %,+1 %,yes,"));
  EXPECT_THAT(folder.read("studies/beam/README.md"), Not(HasSubstr("4.8")));
}

TEST_F(StudyCommandTest, UpdatesTheReadme) {
  command.update_readme = true;
  EXPECT_EQ(study_command(command, engine), 0);
  EXPECT_THAT(folder.read("studies/beam/README.md"), HasSubstr("4.810"));
  EXPECT_THAT(folder.read("studies/beam/README.md"), HasSubstr("| yes"));
  command.quick = true;
  EXPECT_THROW(study_command(command, engine), std::runtime_error);
}

// The quick form lacks the claim's row, and says so without failing.
TEST_F(StudyCommandTest, QuickForm) {
  command.quick = true;
  EXPECT_EQ(study_command(command, engine), 0);
  EXPECT_THAT(folder.read("results/beam/claims.csv"), HasSubstr("not run"));
}

TEST_F(StudyCommandTest, AFailedRunIsAnExitCode) {
  engine.run = [](const Scene&, const BodyMethods&, const Resolution&, const RunOptions&) -> RunResult {
    throw std::runtime_error("no luck");
  };
  EXPECT_EQ(study_command(command, engine), 3);
  EXPECT_THAT(folder.read("results/beam/table.csv"), HasSubstr("no luck"));
}

TEST_F(StudyCommandTest, FindsStudiesByNameAndSuggestsNames) {
  const std::string studies = folder / "studies";
  setenv("FEMSPH_STUDIES", studies.c_str(), 1);
  command.name = "beam";
  command.quick = true;
  EXPECT_EQ(study_command(command, engine), 0);
  command.name = "baem";
  try {
    study_command(command, engine);
    FAIL() << "expected an error";
  } catch (const std::runtime_error& e) {
    EXPECT_THAT(e.what(), HasSubstr("did you mean \"beam\"?"));
  }
  unsetenv("FEMSPH_STUDIES");
}

}  // namespace
}  // namespace femsph::compare
