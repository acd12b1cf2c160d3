// The tables of keys: a reader may read only keys that its table states, and the page shows them all.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "model/input/toml_fields.hpp"
#include "model/scene/reader/reader.hpp"
#include "model/scene/reader/scene_page.hpp"

namespace femsph {
namespace {

using namespace testing;
namespace fs = std::filesystem;

const KeyPage page = {
    "Keys of a test",
    "For a test.",
    {{"", "The top.", {{"title", key_holds::text, "A title.", true}}},
     {"[time]",
      "The time.",
      {{"duration", key_holds::quantity(dimension::time), "How long.", true},
       {"samples", key_holds::count, "How many.", false, "with \"rate\""},
       {"kind", "\"slow\" or \"fast\"", "Which."}}},
     {"[bodies.NAME]", "A body.", {{"size", key_holds::vector(dimension::length), "How large."}}}}};

/// The message to a reader that reads a key which its table does not state; empty if there is none.
template <class Ask>
std::string told(Ask&& ask) {
  const toml::table table = toml::parse("title = \"x\"\n[time]\nduration = \"1 s\"\n");
  Faults faults;
  Fields root(table, faults, page);
  try {
    ask(root);
  } catch (const std::logic_error& e) {
    return e.what();
  }
  return "";
}

TEST(Keys, AReaderMayReadOnlyKeysOfItsTable) {
  const auto time = [](Fields& root) { return *root.table("time", Need::optional, "a table"); };
  EXPECT_EQ(told([&](Fields& root) {
              root.text("title", Need::required);
              Fields t = time(root);
              t.quantity("duration", Need::required, dimension::time);
              t.count("samples", Need::optional, 1, 2);
              t.count("samples", Need::required, 1, 2);  // "with .."
              t.choice<int>("kind", Need::optional, {{"slow", 0}, {"fast", 1}});
            }),
            "");
  EXPECT_EQ(
      told([&](Fields& root) { root.text("name", Need::optional); }),
      "the top level reads the optional key \"name\" (a text), which its table of keys does not state so");
  EXPECT_THAT(told([&](Fields& root) { root.text("title", Need::optional); }), HasSubstr("optional key"));
  EXPECT_THAT(told([&](Fields& root) { time(root).quantity("duration", Need::required, dimension::length); }),
              HasSubstr("[time] reads the required key \"duration\" (a length)"));
  EXPECT_THAT(told([&](Fields& root) {
                time(root).choice<int>("kind", Need::optional, {{"slower", 0}});
              }),
              HasSubstr("\"slower\""));
  EXPECT_THAT(told([&](Fields& root) {
                time(root).choice<int>("kind", Need::required, {{"slow", 0}});
              }),
              HasSubstr("required key \"kind\""));
  EXPECT_THAT(told([&](Fields& root) { root.tables("loads"); }), HasSubstr("no table of keys for loads"));
  EXPECT_THAT(told([&](Fields& root) { root.named_tables("bars", Need::optional, "x"); }),
              HasSubstr("no table of keys for bars.NAME"));
}

TEST(Keys, ThePageShowsEveryKey) {
  EXPECT_EQ(to_markdown(page),
            "# Keys of a test\n\nFor a test.\n\n## At the top of the file\nThe top.\n\n"
            "- `title` (required): a text. A title.\n\n## [time]\nThe time.\n\n"
            "- `duration` (required): a time. How long.\n"
            "- `samples` (required with \"rate\"): a whole number. How many.\n"
            "- `kind`: \"slow\" or \"fast\". Which.\n\n## [bodies.NAME]\nA body.\n\n"
            "- `size`: a vector, each component a length. How large.\n");
}

TEST(Keys, ThePageOfScenesHasItsRareKeys) {
  const std::string text = to_markdown(scene_page());
  for (const char* what :
       {"\n## [[sections]]\n", "\n- `point`: ", "\n- `within`: ", "\n- `samples`: ",
        "\n`quantity = \"principal_stress\"`", "\n`shape = \"box\"`", "\n`law = \"plastic\"`"})
    EXPECT_THAT(text, HasSubstr(what));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110u) << line;
}

// Every scene of the repository is read with its tables of keys; a key that is read and not stated would
// throw std::logic_error. Scenes that are faulty on purpose are refused.
TEST(Keys, EverySceneIsReadByItsTable) {
  int scenes = 0;
  for (const char* folder : {"studies", "tests/scenes", "tests/field/scenes"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FEMSPH_SOURCE_DIR) / folder)) {
      const std::string name = entry.path().filename().string();
      if (entry.path().extension() != ".toml" || name == "study.toml") continue;
      if (entry.path().string().find("results") != std::string::npos) continue;
      const std::string text = read_text_file(entry.path().string(), "a scene");
      if (text.find("\"mesh\"") != std::string::npos) continue;  // their keys: the next test
      ++scenes;
      try {
        parse_scene(text, entry.path().string());
      } catch (const InputError&) {
      }
    }
  EXPECT_GT(scenes, 50);
}

// Keys that few scenes have, each read once.
TEST(Keys, RareKeysAreStated) {
  const std::string top =
      "[model]\nplane = \"none\"\nmotion = \"large\"\n[materials.a]\nlaw = \"plastic\"\nyoung = \"1 Pa\"\n"
      "poisson = 0\ndensity = \"1 kg/m^3\"\nyield = \"1 Pa\"\n";
  const std::string jc =
      "[materials.a.johnson_cook]\nB = \"1 Pa\"\nn = 1\nC = 0.1\nreference_rate = \"1 1/s\"\nm = 1\n"
      "melting = \"1000 K\"\nroom = \"300 K\"\ntemperature = \"300 K\"\nheat_capacity = \"1 J/(kg K)\"\n"
      "heat_share = 0.9\n";
  const std::string rest = "[time]\nduration = \"1 s\"\nsamples = 1\nsnapshots = 0\n";
  const auto body = [](const std::string& keys) { return "[bodies.b]\n" + keys + "\nmaterial = \"a\"\n"; };
  const std::string ball =
      "shape = \"ball\"\ncentre = [\"0 m\", \"0 m\", \"0 m\"]\nradius = \"1 m\"\naxis = \"x\"\npart = "
      "\"half\"\nfiner = 2";
  EXPECT_NO_THROW(parse_scene(top + jc + body(ball) + rest, "scene.toml"));
  for (const std::string mesh : {"shape = \"mesh\"\nfile = \"none.msh\"\nunit = \"mm\"\npieces = 2\n"
                                 "open_seams = true",
                                 "shape = \"sphere\"\ncentre = 1\nradius = 1"})
    EXPECT_THROW(parse_scene(top +
                                 "hardening = \"1 Pa\"\ntension = \"sign\"\ntensile_strength = \"1 Pa\"\n"
                                 "integration = \"return\"\n" +
                                 body(mesh) + rest,
                             "scene.toml"),
                 InputError);
}

}  // namespace
}  // namespace femsph
