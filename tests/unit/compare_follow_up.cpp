// One fault of a study gives one message: what refers to a faulty run, scene or quantity adds none.

#include <gmock/gmock.h>

#include "compare/study/reader/study.hpp"
#include "compare_support.hpp"

namespace femsph::compare {
namespace {

using namespace test;  // of compare_support.hpp
using ::testing::AllOf, ::testing::EndsWith, ::testing::HasSubstr, ::testing::Not, ::testing::StartsWith;

/// Everything in it refers to the runs, to the scene or to the quantity.
const std::string good = R"(title = "A study"
[[limits]]
scene = "scene.toml"
divisions = "40x4"
[[runs]]
cases = ["a", "b"]
methods = ["fem-full"]
divisions = ["20x2", "40x4"]
quick = ["a"]
)" + tip_quantity("tip", "scene = \"scene.toml\"\nmethods = [\"fem-full\"]\n" + cantilever_tip) +
                         R"([[series]]
file = "tip.csv"
kind = "error"
quantity = "tip"
cases = ["a"]
methods = ["fem-full"]
[[paper]]
quantity = "tip"
cases = ["a"]
error_percent = 1
source = "fig 1"
[[price]]
name = "tip"
quantity = "tip"
base = "fem-full"
)" + below_claim("a", "tip") +
                         R"([[bounds]]
cases = ["a"]
methods = ["fem-full"]
quantity = "tip"
error_percent = 50
[[expectations]]
cases = ["b"]
methods = ["fem-full"]
messages = ["is off"]
reason = "a test"
)";

class StudyFollowUp : public ::testing::Test {
 protected:
  Folder folder{"follow_up"};
  std::string file = folder.write("beam/study.toml", good);
  void SetUp() override { folder.write("beam/scene.toml", cantilever_toml); }

  /// All messages about the study with `old` replaced, without places.
  std::string said(const std::string& old, const std::string& instead) {
    try {
      parse_study(scene_text::replaced(good, old, instead), file);
    } catch (const InputError& e) {
      std::string all;
      for (const Fault& fault : e.faults()) all += (all.empty() ? "" : " | ") + fault.text;
      return all;
    }
    return "";
  }
};

TEST_F(StudyFollowUp, TheStudyItselfIsGood) { EXPECT_EQ(said("title", "title"), ""); }

TEST_F(StudyFollowUp, OfRuns) {
  EXPECT_THAT(said("methods = [\"fem-full\"]", "methods = [\"fem-ful\"]"),
              AllOf(HasSubstr("no method \"fem-ful\""), Not(HasSubstr(" | "))));
  EXPECT_EQ(said("divisions = [\"20x2\", \"40x4\"]", "divisions = [\"20x2\", \"40*4\"]"),
            "\"40*4\" in \"divisions\"; expected 2 whole numbers with \"x\" between");
  EXPECT_EQ(said("cases = [\"a\", \"b\"]", "cases = \"a\""),
            "\"cases\" is a text; expected a list of names, one for each spacing or division");
  EXPECT_THAT(said("quick = [\"a\"]", "quick = [\"a\"]\noptions = {hourglas = 1}"),
              AllOf(HasSubstr("unknown key \"hourglas\""), Not(HasSubstr(" | "))));
}

TEST_F(StudyFollowUp, OfAMisspeltKey) {
  for (const auto& [key, text] : scene_text::with_a_key_misspelt(good)) {
    const std::string message = said(good, text), wrong = key[0] + key;
    EXPECT_THAT(message, StartsWith("unknown key \"" + wrong + "\""));
    EXPECT_THAT(message, EndsWith("did you mean \"" + key + "\"?"));
    EXPECT_THAT(message, Not(HasSubstr(" | ")));
  }
}

TEST_F(StudyFollowUp, OfAMisspeltTable) {
  for (const std::string table : {"[[runs]]", "[[quantities]]", "[[bounds]]"}) {
    const std::string wrong = "[[" + table.substr(2, 1) + table.substr(2);
    EXPECT_THAT(said(table, wrong),
                AllOf(StartsWith("unknown key"), HasSubstr("did you mean"), Not(HasSubstr(" | "))));
  }
}

// The keys that a kind of series or a reduction needs are not known when its word is wrong.
TEST_F(StudyFollowUp, OfAWrongWord) {
  EXPECT_THAT(said("kind = \"error\"", "kind = \"errors\""),
              AllOf(StartsWith("\"kind\" is \"errors\""), Not(HasSubstr(" | "))));
  EXPECT_THAT(said("kind = \"below\"", "kind = \"belw\""),
              AllOf(StartsWith("\"kind\" is \"belw\""), Not(HasSubstr(" | "))));
  EXPECT_THAT(said("unit = \"mm\"", "unit = \"mm\"\nreduce = \"integrl\""),
              AllOf(StartsWith("\"reduce\" is \"integrl\""), Not(HasSubstr(" | "))));
}

TEST_F(StudyFollowUp, OfAMissingQuantity) {
  EXPECT_THAT(said("[[price]]\nname = \"tip\"\nquantity = \"tip\"", "[[price]]\nname = \"tip\""),
              AllOf(StartsWith("missing \"quantity\" in [[price]]"), Not(HasSubstr(" | "))));
}

TEST_F(StudyFollowUp, OfAScene) {
  folder.write("beam/scene.toml", "title = 1\n");
  EXPECT_THAT(said("title", "title"),
              AllOf(StartsWith("the scene \"scene.toml\" cannot be used"), Not(HasSubstr(" | "))));
}

TEST_F(StudyFollowUp, OfAQuantity) {
  EXPECT_THAT(said("name = \"tip\"\nprobe", "probe"),
              AllOf(StartsWith("missing \"name\" in [[quantities]]"), Not(HasSubstr(" | "))));
  EXPECT_THAT(said("probe = \"tip\"", "column = \"tip_yy\""),
              AllOf(StartsWith("no column of a history is called \"tip_yy\""), HasSubstr("did you mean"),
                    Not(HasSubstr(" | "))));
}

}  // namespace
}  // namespace femsph::compare
