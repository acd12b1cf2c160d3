// What a user reads when a scene file is wrong: the complete message for every file of tests/scenes/bad.
// Any bytes give a Scene or an InputError.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <set>

#include "model/scene/reader/reader.hpp"
#include "model_faults.hpp"

using namespace femsph;

namespace {

using test::scenes_folder;

std::string message_of_file(const std::string& file) {
  try {
    read_scene(file);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

struct BadScene {
  const char* name;
  std::vector<std::string>
      lines;  ///< the message, each line without the file name in front; FOLDER stands for tests/scenes
};

std::ostream& operator<<(std::ostream& out, const BadScene& bad) { return out << bad.name; }

const std::vector<BadScene> bad_scenes = {
    {"five_faults",
     {R"(2:9: "plane" is "stres"; expected "stress", "strain" or "none"; did you mean "stress"?)",
      R"(7:11: "poisson" is 0.7; expected a number above -1 and below 0.5 (a stable, compressible material))",
      R"(11:9: "shape" is "boxx"; expected "box", "disc", "sphere", "mesh", "ring", "cylinder", "tube", "quadrilateral" or "ball"; did you mean "box"?)",
      R"(26:12: "quantity" is "temperature"; expected "displacement", "velocity", "stress", "strain", "plastic_strain", "equivalent_stress", "principal_stress" or "pressure")",
      R"(30:12: "duration" is 0 ms; expected a time greater than zero)"}},
    {"mesh_of_triangles",
     {R"(12:8: "FOLDER/triangles.msh" holds cells of type "Triangle 3"; expected only linear quadrilaterals (in Gmsh: Recombine Surface, first order))"}},
    {"misspelt_key",
     {R"(6:1: unknown key "yuong" in [materials.steel]; expected "law", "young", "poisson" or "density"; did you mean "young"?)"}},
    {"name_twice",
     {R"(30:8: the name "tip" is taken; expected a name that no other probe, section or rigid body has)"}},
    {"nothing_at_all",
     {R"(1:1: missing "model"; expected a table with plane = "stress", "strain" or "none")",
      R"(1:1: missing "materials"; expected at least one table such as [materials.steel])",
      R"(1:1: missing "bodies"; expected at least one table such as [bodies.beam])",
      R"(1:1: missing "time"; expected a table with duration = "50 ms" or the like)"}},
    {"nothing_to_settle",
     {R"(25:1: nothing could move that would settle; expected [[loads]], [gravity] or [[initial]] with a value other than zero)"}},
    {"number_without_unit",
     {R"(13:13: "thickness" is a plain number; expected a length with its unit, such as "10 mm")"}},
    {"poisson_of_a_liquid",
     {R"(7:11: "poisson" is 0.5; expected a number above -1 and below 0.5 (a stable, compressible material))"}},
    {"probe_outside",
     {R"(27:9: "point" lies outside body "beam"; expected a point of its box 1000 x 100 mm: x in [0, 1000] mm, y in [0, 100] mm)"}},
    {"sides_that_do_not_meet",
     {R"(21:6: the sides "x+ x-" do not meet; expected sides with a common corner)"}},
    {"syntax",
     {R"(2:16: Error while parsing string: unescaped control characters other than TAB (U+0009) are explicitly prohibited)"}},
    {"thickness_in_space",
     {R"(13:13: "thickness" in a three-dimensional scene; expected it only with plane = "stress" or "strain")"}},
    {"times_that_go_back",
     {R"(23:19: the times do not increase; expected each time later than the one before)"}},
    {"unknown_material", {R"(14:12: unknown material "steal"; expected "steel"; did you mean "steel"?)"}},
    {"unknown_side",
     {R"(17:6: unknown side "z-"; expected "x-", "x+", "y-", "y+" or "all"; did you mean "x-"?)"}},
    {"unknown_unit",
     {R"(6:9: "young": unknown unit "Gpa" in "210 Gpa"; expected a pressure with its unit, such as "210 GPa")"}},
    {"wrong_dimension",
     {R"(8:11: "density": "7850 kg/m^2" is not a density; expected a density with its unit, such as "7850 kg/m^3")"}},
    {"z_in_a_plane_scene",
     {R"(18:7: unknown component "z"; expected "x" or "y" in a plane scene)",
      R"(22:9: "force" has 3 components; expected 2 (x, y) in a plane scene)"}},
};

class BadScenes : public testing::TestWithParam<BadScene> {};

std::string text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Whether the text is refused. Any other exception than InputError fails the test.
bool refused(const std::string& text) {
  try {
    parse_scene(text, scenes_folder + "mutated.toml");
  } catch (const InputError& e) {
    EXPECT_FALSE(e.faults().empty());
    EXPECT_EQ(std::string(e.what()).find('\0'), std::string::npos);
    return true;
  }
  return false;
}

}  // namespace

TEST_P(BadScenes, GiveThisMessage) {
  const std::string file = scenes_folder + "bad/" + GetParam().name + ".toml";
  std::string expected;
  for (const std::string& line : GetParam().lines)
    expected += (expected.empty() ? "" : "\n") + file + ":" + line;
  if (const auto at = expected.find("FOLDER/"); at != std::string::npos)
    expected.replace(at, 7, scenes_folder);
  EXPECT_EQ(message_of_file(file), expected);
}

INSTANTIATE_TEST_SUITE_P(Faults, BadScenes, testing::ValuesIn(bad_scenes), [](const auto& info) {
  return std::string(info.param.name);
});

TEST(BadScenes, AreAllTested) {
  std::set<std::string> files, tested;
  for (const auto& entry : std::filesystem::directory_iterator(scenes_folder + "bad"))
    files.insert(entry.path().stem().string());
  for (const BadScene& bad : bad_scenes) tested.insert(bad.name);
  EXPECT_EQ(files, tested);
}

TEST(Faults, AFileThatIsNone) {
  EXPECT_EQ(message_of_file(scenes_folder + "none.toml"),
            scenes_folder + "none.toml: no such file; expected a scene file (TOML)");
  EXPECT_EQ(message_of_file(scenes_folder + "bad"),
            scenes_folder + "bad: is a directory; expected a scene file (TOML)");
}

TEST(Faults, APipeIsNotWaitedFor) {
  const std::string pipe = testing::TempDir() + "femsph_pipe.toml";
  std::remove(pipe.c_str());
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(message_of_file(pipe), pipe + ": is a pipe or a device; expected a scene file (TOML)");
  EXPECT_EQ(message_of_file("/dev/zero"), "/dev/zero: is a pipe or a device; expected a scene file (TOML)");
  std::remove(pipe.c_str());
}

TEST(Faults, SuggestionsFollowTheFourSlips) {
  const std::vector<std::string> names = {"young", "poisson", "density"};
  for (const char* slip : {"yong", "yooung", "yaung", "yuong"})
    EXPECT_EQ(did_you_mean(slip, names), "; did you mean \"young\"?");
  EXPECT_EQ(did_you_mean("spacing", names), "");
}

// Deterministic: the same few hundred damaged files every time.
TEST(Totality, DamagedFilesGiveASceneOrAnInputError) {
  const std::string good = text_of(scenes_folder + "cantilever.toml");
  const std::vector<std::string> words = {
      "\"",
      "[",
      "]]",
      "{",
      "=",
      "\n",
      ".",
      "nan",
      "-inf",
      "1e400",
      "99999999999999999999",
      "0 mm",
      "\xff",
      std::string(1, '\0'),
      "\xc3\xa9",
      "mesh",
      "none",
      "[[loads]]\n",
      "9223372036854775807",
      "true"};
  std::mt19937 random(20240229);
  const auto below = [&](std::size_t n) { return std::size_t(random() % n); };
  for (int i = 0; i < 600; ++i) {
    std::string text = good;
    for (std::size_t changes = 1 + below(6); changes > 0; --changes) {
      const std::size_t at = below(text.size()), length = below(40);
      switch (below(4)) {
        case 0:
          text[at] = char(random());
          break;
        case 1:
          text.erase(at, length);
          break;
        case 2:
          text.insert(at, words[below(words.size())]);
          break;
        default:
          text.insert(below(text.size()), text.substr(at, length));
      }
    }
    refused(text);
  }
}

// Thousands of bodies, and as many loads that name none of them: the number of messages and the time of the
// search for similar names stay bounded.
TEST(Totality, ManyFaultsOfManyNamesStaySmall) {
  std::string text = "[model]\nplane = \"stress\"\n";
  for (int i = 0; i < 6000; ++i) text += "[bodies.b" + std::to_string(i) + "]\n";
  for (int i = 0; i < 6000; ++i) text += "[[loads]]\nbody = \"c\"\n";
  try {
    parse_scene(text, "many.toml");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(e.faults().size(), 1000u);
    EXPECT_LT(std::string(e.what()).size(), 4'000'000u);
  }
}

TEST(Totality, DepthAndSizeAreBounded) {
  const auto repeated = [](const std::string& s, int n) {
    std::string all;
    for (int i = 0; i < n; ++i) all += s;
    return all;
  };
  EXPECT_TRUE(refused(repeated("a.", 400'000) + "a = 1"));
  EXPECT_TRUE(refused("[" + repeated("1.", 400'000) + "a]"));
  EXPECT_TRUE(refused(repeated("\"=\".1.", 100'000) + "a = 1"));
  EXPECT_TRUE(refused("x = " + repeated("[", 400'000)));
  EXPECT_TRUE(refused("x = " + repeated("{a = ", 100'000)));
  EXPECT_TRUE(
      refused("x = " + repeated("[\n{a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a = ", 120) +
              "1" + repeated("}]", 120)));
  EXPECT_TRUE(refused(repeated("\n", 2'000'000)));
}
