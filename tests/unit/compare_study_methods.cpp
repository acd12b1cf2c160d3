// A method for each body in a study: its name in tables, its options, its mistakes.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/study/reader/study.hpp"
#include "compare_support.hpp"

namespace femsph::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace test;

const std::string blocks_toml =
    scene_text::model("stress") + scene_text::steel() +
    scene_text::box("upper", "100 50 mm", scene_text::origin("0 50 mm") + scene_text::thick("10 mm")) +
    scene_text::box("lower", "100 50 mm", scene_text::thick("10 mm")) +
    scene_text::support("y-", "x y", scene_text::of_body("lower")) + scene_text::contact("upper", "lower") +
    scene_text::initial("0 -5 m/s", scene_text::of_body("upper")) +
    scene_text::probe("tip", "displacement", "50 100 mm", scene_text::of_body("upper")) +
    scene_text::time("0.1 ms");

class StudyMethods : public ::testing::Test {
 protected:
  Folder folder{"study-methods"};
  void SetUp() override { folder.write("blocks/scene.toml", blocks_toml); }

  Study read(const std::string& methods, const std::string& more = "", const std::string& rest = "") {
    return parse_study(
        fmt::format("title = \"Blocks\"\n[[runs]]\nmethods = {}\nspacing = [\"10 mm\"]\n{}", methods, more) +
            tip_quantity("sink") + rest,
        folder / "blocks/study.toml");
  }
  std::string fault(const std::string& methods, const std::string& more = "", const std::string& rest = "") {
    return message_of([&] { read(methods, more, rest); });
  }
  std::vector<std::string> labels(const std::string& methods, const std::string& more = "") {
    std::vector<std::string> all;
    for (const PlannedRun& run : read(methods, more).runs) all.push_back(run.label);
    return all;
  }
};

const char* const fem_on_sph = "[\"upper=fem-full,lower=sph-corrected\"]";

TEST_F(StudyMethods, TheNameInTablesIsTheText) {
  EXPECT_THAT(
      labels("[\"fem-full\", \"upper=fem-full,lower=sph-corrected\", \"fem-sri,upper=sph-corrected\"]"),
      ElementsAre("fem-full", "upper=fem-full,lower=sph-corrected", "fem-sri,upper=sph-corrected"));
  EXPECT_THAT(labels(fem_on_sph, "label = \"FEM on SPH\"\n"), ElementsAre("FEM on SPH"));
  const Study study = read(fem_on_sph);
  const Scene& scene = study.scenes.at("scene.toml");
  EXPECT_EQ(study.runs[0].methods.of(scene.bodies[0]).name, "fem-full");
  EXPECT_EQ(study.runs[0].methods.of(scene.bodies[1]).name, "sph-corrected");
}

// An option stands beside the method of the body to which it applies.
TEST_F(StudyMethods, OptionsApplyToTheBodiesThatHaveThem) {
  EXPECT_THAT(labels(fem_on_sph, "options = {smoothing = 1.2}\n"),
              ElementsAre("upper=fem-full,lower=sph-corrected smoothing=1.2"));
  EXPECT_THAT(
      labels(fem_on_sph, "smoothing_lengths = [1.0, 1.4]\n"),
      ElementsAre("upper=fem-full,lower=sph-corrected h=1d", "upper=fem-full,lower=sph-corrected h=1.4d"));
  const Study study = read(fem_on_sph, "options = {smoothing = 1.2}\n");
  const Body& lower = study.scenes.at("scene.toml").bodies[1];
  EXPECT_EQ(std::get<sph::Options>(study.runs[0].methods.of(lower).options).smoothing, 1.2);
  EXPECT_THAT(fault(fem_on_sph, "options = {alpha = 1}\n"),
              HasSubstr("\"alpha\" does nothing with upper=fem-full,lower=sph-corrected: it is an option of "
                        "SPH, and it belongs to classic and to updated SPH"));
  EXPECT_THAT(
      fault("[\"upper=fem-full,lower=fem-sri\"]", "smoothing_lengths = [1.0]\n"),
      HasSubstr("\"smoothing_lengths\" with upper=fem-full,lower=fem-sri; expected it with SPH only"));
}

TEST_F(StudyMethods, OtherTablesKnowTheName) {
  const std::string bound =
      "[[bounds]]\nmethods = [\"upper=fem-full,lower=sph-corrected\"]\nmomentum_drift = 1e-9\n";
  EXPECT_EQ(fault(fem_on_sph, "", bound), "");
  EXPECT_THAT(fault("[\"upper=fem-full,lower=sph-virtual\"]", "", bound),
              HasSubstr("did you mean \"upper=fem-full,lower=sph-virtual\"?"));
}

TEST_F(StudyMethods, MistakesHaveTheirPlace) {
  EXPECT_THAT(fault("[\"uper=fem-full,lower=sph-corrected\"]"),
              HasSubstr("study.toml:3:11: no body \"uper\"; expected \"upper\" or \"lower\"; did you mean "
                        "\"upper\"?"));
  EXPECT_THAT(fault("[\"upper=fem-full\"]"), HasSubstr("no method is given for the body lower"));
  const std::string advice = "[[advice]]\nquantity = \"sink\"\nerror = 1\nmethods = ";
  EXPECT_EQ(fault(fem_on_sph, "", advice + "[\"fem-full\", \"upper=fem-full,lower=sph-corrected\"]\n"), "");
  EXPECT_THAT(fault(fem_on_sph, "", advice + "[\"upper=fem-full,lowr=sph-corrected\"]\n"),
              HasSubstr("did you mean \"lower\"?"));
  // A scene that cannot be read is reported; its bodies are then not known.
  EXPECT_THAT(fault(fem_on_sph, "scene = \"none.toml\"\n"),
              AllOf(HasSubstr("none.toml"), ::testing::Not(HasSubstr("no body"))));
}

}  // namespace
}  // namespace femsph::compare
