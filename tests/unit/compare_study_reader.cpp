// Study files, valid and faulty: every fault is found and explained, with its place.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "compare/study/reader/study.hpp"
#include "compare_support.hpp"

namespace femsph::compare {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using namespace test;
using scene_text::replaced;

const std::string good_study =
    R"(title = "A study"
[limit]
divisions = "40x4"
degree = 2
[[runs]]
cases = ["1_1", "1_2"]
methods = ["fem-full", "fem-sri"]
divisions = ["20x2", "40x4"]
quick = ["1_1"]
[[runs]]
methods = ["sph-corrected"]
spacing = ["20 mm", "2.5 mm"]
options = {smoothing = 1.2, kernel = "wendland-c2"}
safety = 0.5
)" + tip_quantity("tip_displacement", reversed + cantilever_tip) +
    inner_quantity("stress_l2", "reduce = \"l2\"\ntheory = \"cantilever_stress\"\n") +
    R"([[paper]]
cases = ["1_2"]
quantity = "tip_displacement"
value = "0.4765 cm"
source = "fig 14"
[[series]]
file = "tip.csv"
kind = "history"
cases = ["1_1"]
probe = "tip"
component = "y"
unit = "mm"
theory = "cantilever_tip"
)" + below_claim("1_1", "tip_displacement");

class StudyReader : public ::testing::Test {
 protected:
  Folder folder{"reader"};
  std::string file = folder.write("beam/study.toml", good_study);
  void SetUp() override { folder.write("beam/scene.toml", cantilever_toml); }

  Study read(const std::string& text) { return parse_study(text, file); }
  std::string message(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& e) {
      std::string all = e.what();
      for (std::size_t at; (at = all.find(file)) != std::string::npos;)
        all.replace(at, file.size(), "study.toml");
      return all;
    }
    return "";
  }
};

TEST_F(StudyReader, ReadsAGoodFile) {
  const Study study = read_study(file);
  EXPECT_EQ(study.name, "beam");
  ASSERT_EQ(study.runs.size(), 6u);
  EXPECT_EQ(study.runs[0].case_name, "1_1");
  EXPECT_EQ(study.runs[1].label, "fem-sri");
  EXPECT_TRUE(study.runs[1].quick);
  EXPECT_FALSE(study.runs[2].quick);
  EXPECT_EQ(study.runs[2].resolution.divisions, (std::array<int, 3>{40, 4, 0}));
  EXPECT_EQ(study.runs[5].case_name, "d=2.5mm");
  EXPECT_DOUBLE_EQ(study.runs[5].resolution.spacing, 2.5e-3);
  EXPECT_EQ(study.runs[5].label, "sph-corrected smoothing=1.2 kernel=wendland-c2");
  const auto& options = std::get<sph::Options>(study.runs[5].methods.entries.at(0).method.options);
  EXPECT_DOUBLE_EQ(options.smoothing, 1.2);
  EXPECT_EQ(options.kernel, sph::KernelKind::wendland_c2);
  EXPECT_DOUBLE_EQ(study.runs[5].march.safety, 0.5);
  EXPECT_NE(study.runs[0].ladder, study.runs[5].ladder);
  EXPECT_DOUBLE_EQ(study.quantities[0].observed.unit.factor, 1e-3);
  EXPECT_EQ(study.quantities[1].observed.unit.name, "%");
  EXPECT_NEAR(*study.paper[0].value, 4.765, 1e-12);  // in the quantity's unit
  EXPECT_EQ(study.limit->degree, 2);
  EXPECT_EQ(study.claims[0].rows.cases, std::vector<std::string>{"1_1"});
}

TEST_F(StudyReader, FindsAllFaultsAtOnceWithTheirPlaces) {
  std::string text = replaced(good_study, "\"fem-sri\"", "\"fem-sir\"");
  text = replaced(text, "safety = 0.5", "saftey = 0.5");
  text = replaced(text, "theory = \"cantilever_tip\"", "theory = \"cantilver_tip\"");
  EXPECT_THAT(
      message(text),
      AllOf(HasSubstr("study.toml:7:11: "), HasSubstr("did you mean \"fem-sri\"?"),
            HasSubstr("study.toml:14:1: unknown key \"saftey\""), HasSubstr("did you mean \"safety\"?"),
            HasSubstr("study.toml:21:10: "), HasSubstr("did you mean \"cantilever_tip\"?")));
}

TEST_F(StudyReader, FaultsInRuns) {
  EXPECT_THAT(message(replaced(good_study, "\"40x4\"]", "\"40*4\"]")),
              HasSubstr("\"40*4\" in \"divisions\"; expected 2 whole numbers"));
  EXPECT_THAT(
      message(replaced(good_study, "\"40x4\"]", "\"40x4x2\"]")), HasSubstr("expected 2 whole numbers"));
  EXPECT_THAT(message(replaced(good_study, "cases = [\"1_1\", \"1_2\"]", "cases = [\"1_1\"]")),
              HasSubstr("1 cases for 2 resolutions"));
  EXPECT_THAT(message(replaced(good_study, "quick = [\"1_1\"]", "quick = [\"1_11\"]")),
              HasSubstr("did you mean \"1_1\"?"));
  EXPECT_THAT(message(replaced(good_study, "smoothing = 1.2", "smothing = 1.2")),
              HasSubstr("did you mean \"smoothing\"?"));
  EXPECT_THAT(message(replaced(good_study, "smoothing = 1.2", "smoothing = 0")),
              HasSubstr("\"smoothing\" is 0; expected a number from 0.6 to 4"));
  EXPECT_THAT(message(replaced(good_study, "safety = 0.5", "safety = 2.5")),
              HasSubstr("\"safety\" is 2.5; expected a number above 0, up to 2"));
  EXPECT_THAT(message(replaced(good_study, "quick = [\"1_1\"]", "spacing = [\"1 mm\"]")),
              HasSubstr("expected either \"spacing\""));
  EXPECT_THAT(message(replaced(good_study, "quick = [\"1_1\"]", "scene = \"none.toml\"")),
              HasSubstr("the scene \"none.toml\" cannot be used"));
}

TEST_F(StudyReader, FaultsInQuantitiesAndSeries) {
  EXPECT_THAT(message(replaced(good_study, "probe = \"tip\"", "probe = \"tpi\"")),
              HasSubstr("study.toml:17:9: no probe is called \"tpi\" in scene.toml"));
  EXPECT_THAT(message(replaced(good_study, "component = \"y\"", "component = \"yy\"")),
              HasSubstr("expected \"x\" or \"y\""));
  EXPECT_THAT(message(replaced(good_study, "unit = \"mm\"", "unit = \"MPa\"")),
              HasSubstr("expected a unit of the same kind as \"m\""));
  EXPECT_THAT(message(replaced(good_study, "reduce = \"l2\"", "reduce = \"max\"")),
              HasSubstr("\"reduce\" does not fit"));
  EXPECT_THAT(message(replaced(good_study, "theory = \"cantilever_tip\"", "theory = \"bar_stress\"")),
              HasSubstr("bar theory needs"));
  EXPECT_THAT(
      message(replaced(good_study, "theory = \"cantilever_tip\"", "theory = \"cantilever_tip_history\"")),
      HasSubstr("depends on time"));
  EXPECT_THAT(message(replaced(good_study, "file = \"tip.csv\"", "file = \"../tip.csv\"")),
              HasSubstr("\"file\" is \"../tip.csv\""));
  EXPECT_THAT(message(replaced(good_study, "kind = \"history\"", "kind = \"profile\"")),
              HasSubstr("\"kind\" does not fit"));
}

TEST_F(StudyReader, AnOffsetHasTheUnitOfTheTable) {
  const auto moved = [&](const std::string& key) { return replaced(good_study, "sign = \"reversed\"", key); };
  EXPECT_THAT(message(moved("offset = \"1 MPa\"")), HasSubstr("\"offset\": "));
  EXPECT_THAT(message(moved("offset = \"1 cm\"")),
              HasSubstr("\"offset\" moves the value away from theory and limit"));
  std::string text = replaced(moved("offset = \"1 cm\""), "theory = \"cantilever_tip\"\n[[quantities]]",
                              "reference = \"7 mm\"\n[[quantities]]");
  text = replaced(text, "[limit]\ndivisions = \"40x4\"\ndegree = 2\n", "");
  EXPECT_DOUBLE_EQ(read(text).quantities[0].offset, 10);  // mm
}

// A filter that no planned run fits is found before the runs, even if each of its words exists.
TEST_F(StudyReader, FaultsInPaperAndClaims) {
  EXPECT_THAT(message(replaced(good_study, "value = \"0.4765 cm\"", "value = \"0.4765 MPa\"")),
              HasSubstr("\"value\": "));
  EXPECT_THAT(message(replaced(
                  good_study, "method = \"fem-full\", quantity", "method = \"sph-corrected\", quantity")),
              HasSubstr("no run has the method"));
  EXPECT_THAT(message(replaced(good_study, "method = \"fem-full\", quantity",
                               "method = \"sph-corrected smoothing=1.2 kernel=wendland-c2\", quantity")),
              HasSubstr("no run of the study gives 1_1 sph-corrected"));
  EXPECT_EQ(message(replaced(good_study, "bound = 10", "bond = 10")),
            "study.toml:47:1: unknown key \"bond\" in [[claims]]; expected \"id\", \"source\", \"text\", "
            "\"note\", \"reference\", \"kind\", \"rows\" or \"bound\"; did you mean \"bound\"?");
}

TEST_F(StudyReader, CollectsItsNeighbours) {
  const std::string all = folder.write("all/study.toml", "title = \"All\"\nstudies = [\"beam\"]\n");
  const Study study = read_study(all);
  ASSERT_EQ(study.collected.size(), 1u);
  EXPECT_EQ(study.collected[0].name, "beam");
  folder.write("more/study.toml", "title = \"More\"\nstudies = [\"all\"]\n");
  EXPECT_THROW(read_study(folder / "more/study.toml"), InputError);
  folder.write("all/study.toml", "title = \"All\"\nstudies = [\"all\"]\n");
  EXPECT_THROW(read_study(all), InputError);
  folder.write("all/study.toml", "title = \"All\"\nstudies = [\"baem\"]\n");
  EXPECT_THROW(read_study(all), InputError);
}

// A study of no scene has none whose price or limit could be told.
TEST_F(StudyReader, AdviceWithoutAScene) {
  const std::string text =
      "title = \"x\"\n[[quantities]]\nname = \"tip\"\nprobe = \"tip\"\n[[advice]]\nquantity = \"tip\"\nerror "
      "= 1\n";
  EXPECT_THAT(message(text), HasSubstr("the study runs nothing"));
}

TEST_F(StudyReader, AnEmptyStudyIsRefused) {
  EXPECT_THAT(message("title = \"x\"\n"), HasSubstr("the study runs nothing"));
}

// The studies of this repository can be read, and their theories fit their scenes.
TEST(Studies, AreAllReadable) {
  for (const std::string name : {"uniaxial", "boundary", "fem-mesh", "spacing", "depth", "return-mapping",
                                 "two-blocks", "rc-beam", "plastic-beam", "cost", "paper"}) {
    const Study study = read_study(fmt::format("{}/studies/{}/study.toml", FEMSPH_SOURCE_DIR, name));
    EXPECT_EQ(study.name, name);
    EXPECT_TRUE(!study.collected.empty() ||
                std::any_of(study.runs.begin(), study.runs.end(), [](const auto& run) { return run.quick; }))
        << name;
  }
}

}  // namespace
}  // namespace femsph::compare
