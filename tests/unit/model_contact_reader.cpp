// What a scene file says about rigid bodies and contacts.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/motion/effects/catalogue.hpp"
#include "model_faults.hpp"
#include "tests/scene_text.hpp"

namespace femsph {
namespace {

using testing::HasSubstr;

std::string weight_on_beam(const std::string& rest, const std::string& weight = "mass = \"300 kg\"\n") {
  using namespace scene_text;
  return model("stress") + steel() + R"([bodies.weight]
shape = "disc"
rigid = true
centre = ["0 mm", "200 mm"]
radius = "100 mm"
)" + weight +
         box("beam", "1000 100 mm", thick("100 mm")) + scene_text::time("1 ms") + rest;
}

using test::message_of;

TEST(ContactReader, ReadsRigidBodiesAndContacts) {
  const Scene s = parse_scene(weight_on_beam(R"([[contacts]]
between = ["weight", "beam"]
friction = 0.3
[[supports]]
body = "weight"
fix = ["x", "turn"]
[[loads]]
body = "weight"
force = ["0 N", "-5 N"]
)"),
                              "scene.toml");
  EXPECT_TRUE(s.bodies[0].rigid);
  EXPECT_EQ(s.bodies[0].mass, 300);
  EXPECT_FALSE(s.bodies[1].rigid);
  ASSERT_EQ(s.contacts.size(), 1u);
  EXPECT_EQ(s.contacts[0].name, "weight-beam");
  EXPECT_EQ(s.contacts[0].stiffness, 1);
  EXPECT_EQ(s.contacts[0].friction, 0.3);
  EXPECT_EQ(s.supports[0].fixed, (std::array{true, false, false}));
  EXPECT_EQ(s.supports[0].fixed_turn, (std::array{false, false, true}));
  EXPECT_EQ(s.loads[0].place.body, 0u);
  EXPECT_THAT(effects_on(s), testing::IsSupersetOf({"rigid bodies", "contact", "friction"}));
}

// 1000 kg/m^3 x pi 0.1^2 x 0.5 m = 15.708 kg.
TEST(ContactReader, TakesADensityInsteadOfAMass) {
  const Scene s = parse_scene(
      weight_on_beam("", "density = \"1000 kg/m^3\"\nthickness = \"500 mm\"\n"), "scene.toml");
  EXPECT_NEAR(s.bodies[0].mass, 15.708, 1e-3);
}

TEST(ContactReader, ExplainsWhatIsWrong) {
  EXPECT_THAT(message_of(weight_on_beam("[[contacts]]\nbetween = [\"weight\", \"beem\"]\n")),
              HasSubstr("unknown body \"beem\"; expected \"weight\" or \"beam\"; did you mean \"beam\"?"));
  EXPECT_THAT(message_of(weight_on_beam("[[contacts]]\nbetween = [\"beam\"]\n")),
              HasSubstr("\"between\" does not name two bodies"));
  EXPECT_THAT(message_of(weight_on_beam("[[contacts]]\nbetween = [\"weight\", \"beam\"]\nstiffness = 0.0\n")),
              HasSubstr("\"stiffness\" is 0"));
  EXPECT_THAT(
      message_of(weight_on_beam("[[contacts]]\nbetween = [\"weight\", \"beam\"]\n[[contacts]]\nbetween = "
                                "[\"weight\", \"beam\"]\n")),
      HasSubstr("is taken"));
  EXPECT_THAT(message_of(weight_on_beam("[[supports]]\nbody = \"weight\"\nat = \"x-\"\nfix = [\"x\"]\n")),
              HasSubstr("part of body \"weight\", which is rigid"));
  EXPECT_THAT(message_of(weight_on_beam("[[supports]]\nbody = \"weight\"\nfix = [\"z\"]\n")),
              HasSubstr("unknown component \"z\"; expected \"x\", \"y\" or \"turn\""));
  EXPECT_THAT(message_of(weight_on_beam("[[probes]]\nname = \"p\"\nbody = \"weight\"\nquantity = "
                                        "\"velocity\"\npoint = [\"0 mm\", \"200 mm\"]\n")),
              HasSubstr("weight_vx"));
  EXPECT_THAT(message_of(weight_on_beam("", "")), HasSubstr("missing \"mass\""));
  EXPECT_THAT(message_of(weight_on_beam("", "mass = \"1 kg\"\nmaterial = \"steel\"\n")),
              HasSubstr("unknown key \"material\""));
}

TEST(ContactReader, ReadsTiedBodiesAndRefusesWhatTheyCannotHave) {
  const std::string other =
      "[bodies.more]\nshape = \"box\"\norigin = [\"1 m\", \"0 m\"]\nsize = [\"1 m\", \"100 mm\"]\nthickness "
      "= \"100 mm\"\nmaterial = \"steel\"\n";
  const auto tied = [&](const std::string& bodies, const std::string& rest) {
    return weight_on_beam(other + "[[contacts]]\nkind = \"tied\"\nbetween = [" + bodies + "]\n" + rest);
  };
  const Scene s = parse_scene(tied("\"beam\", \"more\"", ""), "scene.toml");
  ASSERT_EQ(s.contacts.size(), 1u);
  EXPECT_TRUE(s.contacts[0].tied);
  EXPECT_THAT(effects_on(s), testing::Contains("tied bodies"));
  EXPECT_THAT(effects_on(s), testing::Not(testing::Contains("contact")));
  EXPECT_THAT(message_of(tied("\"beam\", \"more\"", "friction = 0.3\n")),
              HasSubstr("\"friction\" in a contact of kind \"tied\""));
  EXPECT_THAT(message_of(tied("\"beam\", \"weight\"", "")), HasSubstr("one of two tied bodies is rigid"));
  EXPECT_THAT(
      message_of(weight_on_beam(other + "[[contacts]]\nkind = \"glued\"\nbetween = [\"beam\", \"more\"]\n")),
      HasSubstr("expected \"press\" or \"tied\""));
}

}  // namespace
}  // namespace femsph
