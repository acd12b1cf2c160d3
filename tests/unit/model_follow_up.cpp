// One fault gives one message: what refers to something faulty adds none.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model_faults.hpp"
#include "tests/scene_text.hpp"

namespace femsph {
namespace {

using namespace scene_text;

/// Everything in it refers to the body, to its material or to its sides.
const std::string good =
    model("strain") + steel() + material("other", "elastic", "1 GPa", "0.3", "1000 kg/m^3") +
    box("block", "40 40 mm", thick("1 mm")) +
    "[bodies.ram]\nshape = \"box\"\nsize = [\"40 mm\", \"10 mm\"]\n" + origin("0 40 mm") + rigid("1 kg") +
    support("y-", "x y", of_body("block")) +
    support(
        "y-", "y",
        of_body("block") + "within = [[\"0 mm\", \"0 mm\"], [\"10 mm\", \"10 mm\"]]\n" + named("corner")) +
    R"([[supports]]
body = "ram"
fix = ["x", "turn"]
[[symmetry]]
body = "block"
at = "x-"
[bars.bar]
body = "block"
from = ["0 mm", "20 mm"]
to = ["40 mm", "20 mm"]
area = "10 mm^2"
material = "steel"
[[loads]]
body = "block"
at = "x+"
pressure = "1 MPa"
[[loads]]
body = "block"
point = ["40 mm", "40 mm"]
force = ["0 N", "1 N"]
[[initial]]
body = "block"
spin = "1 rad/s"
centre = ["0 mm", "0 mm"]
[[initial_displacements]]
body = "block"
gradient = [[0, 0], [0, 1e-3]]
)" + contact("block", "ram") +
    probe("p", "stress", "20 20 mm", of_body("block")) +
    section("s", "strain", "10 10 mm", "20 10 mm", of_body("block")) + scene_text::time("1 ms");

/// Keys that the scene above lacks.
const std::string plastic =
    model("strain", large_motion) + plastic_steel("tension = \"sign\"\ntensile_strength = \"10 MPa\"\n") +
    material("metal", "plastic", "210 GPa", "0.3", "7850 kg/m^3", "yield = \"300 MPa\"\n") +
    R"toml([materials.metal.johnson_cook]
B = "400 MPa"
n = 0.3
melting = "1800 K"
m = 1.0
room = "300 K"
heat_capacity = "450 J/(kg K)"
)toml" +
    box("block", "40 40 mm", thick("1 mm")) +
    "[bodies.ram]\nshape = \"disc\"\ncentre = [\"20 mm\", \"50 mm\"]\nradius = \"9 mm\"\nrigid = true\n"
    "density = \"7850 kg/m^3\"\nthickness = \"1 mm\"\n" +
    R"([[supports]]
body = "block"
at = "y-"
fix = ["x", "y"]
velocity = ["0 m/s", "1 m/s"]
history = {ramp = "1 ms"}
[[initial]]
body = "ram"
velocity = ["0 m/s", "-1 m/s"]
[gravity]
acceleration = ["0 m/s^2", "-9.81 m/s^2"]
[damping]
rate = "1 1/s"
)" + section("s", "strain", "10 10 mm", "20 10 mm", of_body("block")) +
    scene_text::time("1 ms");

const std::string to_settle = clamped_beam("100 10 mm", "10 mm") + "[gravity]\n" +
                              "acceleration = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n" + settling("damping") +
                              scene_text::time("1 ms");

/// All messages about a scene, without places.
std::string said(const std::string& text) { return test::faults_of(text, " | "); }

const std::string block_shape = "shape = \"box\"\nsize = [\"40 mm\", \"40 mm\"]\nthickness";

TEST(FollowUp, TheSceneItselfIsGood) { EXPECT_EQ(said(good), ""); }

TEST(FollowUp, OfAShape) {
  EXPECT_EQ(
      said(replaced(good, block_shape, "shape = \"mesh\"\nfile = \"none.msh\"\nunit = \"mm\"\nthickness")),
      "no such file \"none.msh\"; expected a .msh file of Gmsh");
  EXPECT_EQ(
      said(replaced(good, block_shape, "shape = \"boxx\"\nsize = [\"40 mm\", \"40 mm\"]\nthickness")),
      "\"shape\" is \"boxx\"; expected \"box\", \"disc\", \"sphere\", \"mesh\", \"ring\", \"cylinder\", "
      "\"tube\", \"quadrilateral\" or \"ball\"; did you mean \"box\"?");
  EXPECT_EQ(said(replaced(good, block_shape, "shape = \"box\"\nsize = [\"40 mm\"]\nthickness")),
            "\"size\" has 1 component; expected 2 (x, y) in a plane scene");
  EXPECT_EQ(said(replaced(good, block_shape,
                          "shape = \"sphere\"\ncentre = [\"0 m\", \"0 m\"]\nradius = \"1 m\"\nthickness")),
            "a sphere in a plane scene; expected \"disc\"");
}

TEST(FollowUp, OfATableThatIsNone) {
  std::string text = good;
  const auto cut = [&](const std::string& from, const std::string& to) {
    const auto begin = text.find(from);
    text.erase(begin, text.find(to) - begin);
  };
  cut("[materials.steel]", "[materials.other]");
  text = replaced(text, "[materials.other]", "[materials]\nsteel = 5\n[materials.other]");
  EXPECT_EQ(said(text),
            "\"materials.steel\" is a plain number; expected at least one table such as [materials.steel]");
  text = good;
  cut("[bodies.block]", "[bodies.ram]");
  text = replaced(text, "[bodies.ram]", "[bodies]\nblock = \"box\"\n[bodies.ram]");
  EXPECT_EQ(said(text), "\"bodies.block\" is a text; expected at least one table such as [bodies.beam]");
  text = good;
  cut("[bodies.block]", "[[supports]]");
  EXPECT_EQ(said(text), "missing \"bodies\"; expected at least one table such as [bodies.beam]");
}

TEST(FollowUp, OfAMaterial) {
  EXPECT_EQ(said(replaced(good, "law = \"elastic\"", "law = \"elastik\"\nyield = \"1 Pa\"")),
            "\"law\" is \"elastik\"; expected \"elastic\", \"neo-hookean\", \"plastic\" or \"fluid\"; did "
            "you mean \"elastic\"?");
  EXPECT_EQ(said(replaced(good, "young = \"210 GPa\"", "young = 210")),
            "\"young\" is a plain number; expected a pressure with its unit, such as \"210 GPa\"");
}

TEST(FollowUp, OfATensionRule) {
  EXPECT_EQ(said(replaced(plastic, "tension = \"sign\"", "tension = \"sgin\"")),
            "\"tension\" is \"sgin\"; expected \"none\", \"sign\" or \"principal\"; did you mean \"sign\"?");
}

TEST(FollowUp, OfTheModel) {
  EXPECT_EQ(said(replaced(replaced(good, "plane = \"strain\"", "plane = \"strain\"\nmoton = \"large\""),
                          "law = \"elastic\"", "law = \"neo-hookean\"")),
            "unknown key \"moton\" in [model]; expected \"plane\" or \"motion\"; did you mean \"motion\"?");
  EXPECT_EQ(
      said(replaced(good, "plane = \"strain\"", "plane = \"strains\"")),
      "\"plane\" is \"strains\"; expected \"stress\", \"strain\" or \"none\"; did you mean \"strain\"?");
}

TEST(FollowUp, OfARigidBody) {
  EXPECT_EQ(
      said(replaced(good, "rigid = true", "rigid = \"yes\"")), "\"rigid\" is a text; expected true or false");
  EXPECT_EQ(said(replaced(good, "body = \"ram\"\n", "body = \"ram\"\nat = \"x-\"\n")),
            "part of body \"ram\", which is rigid; expected \"all\", which stands for its centre");
  EXPECT_EQ(said(replaced(good, "body = \"ram\"\n", "body = \"rma\"\n")),
            "unknown body \"rma\"; expected \"block\" or \"ram\"; did you mean \"ram\"?");
}

TEST(FollowUp, OfAPlace) {
  EXPECT_EQ(said(replaced(good, "at = \"x+\"", "at = \"x\"")),
            "unknown side \"x\"; expected \"x-\", \"x+\", \"y-\", \"y+\" or \"all\"; did you mean \"x-\"?");
  EXPECT_EQ(said(replaced(good, "at = \"x+\"\n", "")),
            "missing \"at\" in [[loads]]; expected at = \"x-\" (sides, or \"all\") or point = [..] (the "
            "nearest point)");
}

// Required keys, keys of which one must be given, and keys that others depend on. Keys of one letter are
// similar to none.
TEST(FollowUp, OfAMisspeltKey) {
  for (const std::string& scene : {good, plastic, to_settle}) {
    ASSERT_EQ(said(scene), "");
    for (const auto& [key, text] : with_a_key_misspelt(scene)) {
      if (key.size() == 1) continue;
      const std::string message = said(text), wrong = key[0] + key;
      EXPECT_THAT(message, ::testing::StartsWith("unknown key \"" + wrong + "\""));
      EXPECT_THAT(message, ::testing::EndsWith("did you mean \"" + key + "\"?"));
      EXPECT_THAT(message, ::testing::Not(::testing::HasSubstr(" | ")));
    }
  }
}

TEST(FollowUp, OfAMisspeltTable) {
  const auto expect_one = [](const std::string& message, const std::string& key) {
    EXPECT_THAT(message, ::testing::StartsWith("unknown key"));
    EXPECT_THAT(message, ::testing::EndsWith("did you mean \"" + key + "\"?"));
    EXPECT_THAT(message, ::testing::Not(::testing::HasSubstr(" | ")));
  };
  expect_one(said(replaced(good, "[time]", "[tiem]")), "time");
  expect_one(said(replaced(to_settle, "[gravity]", "[gravty]")), "gravity");
  expect_one(said(replaced(plastic, "[materials.metal.johnson_cook]", "[materials.metal.johnsoncook]")),
             "johnson_cook");
}

// A key that is missing and one that is unknown, not similar: two faults.
TEST(FollowUp, AnUnknownKeyHidesNoOther) {
  EXPECT_EQ(said(replaced(good, "duration = ", "\"the end\" = ")),
            "missing \"duration\" in [time]; expected a time with its unit, such as \"50 ms\" | unknown key "
            "\"the end\" in [time]; expected \"duration\", \"samples\" or \"snapshots\"");
}

TEST(FollowUp, OfAProbe) {
  EXPECT_EQ(
      said(replaced(good, "quantity = \"stress\"", "quantity = \"displacment\"\nreading = \"raw\"")),
      "\"quantity\" is \"displacment\"; expected \"displacement\", \"velocity\", \"stress\", \"strain\", "
      "\"plastic_strain\", \"equivalent_stress\", \"principal_stress\" or \"pressure\"; did you mean "
      "\"displacement\"?");
}

}  // namespace
}  // namespace femsph
