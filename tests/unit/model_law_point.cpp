// The driver of one point, its files, and what a scene says of a plastic material.

#include <gmock/gmock.h>

#include "model/input/faults.hpp"
#include "model/motion/effects/catalogue.hpp"
#include "model_faults.hpp"
#include "model_law_support.hpp"
#include "tests/scene_text.hpp"

namespace femsph::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

std::string fault_of(const std::string& text, Plane plane = Plane::stress) {
  try {
    read_path(text, "path.csv", plane);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Path, IsReadByColumn) {
  const auto path = read_path("gxy, exx\r\n1e-3, 2e-3\r\n\n0, -4\n", "path.csv", Plane::strain);
  ASSERT_EQ(path.size(), 2u);
  EXPECT_EQ(path[0], (Strain{2e-3, 0, 0, 1e-3, 0, 0}));
  EXPECT_EQ(path[1], (Strain{-4, 0, 0, 0, 0, 0}));
}

TEST(Path, FaultsNameTheLine) {
  EXPECT_EQ(
      fault_of("exx,eyz\n1,2\n"),
      R"(path.csv:1:2: column 2 of the path is "eyz"; expected "exx", "eyy" or "gxy"; did you mean "eyy"?)");
  EXPECT_THAT(fault_of("exx,ezz\n"), HasSubstr(R"("ezz"; expected "exx", "eyy" or "gxy")"));
  EXPECT_EQ(fault_of("exx,exx\n"), R"(path.csv:1:2: column "exx" is given twice)");
  EXPECT_EQ(fault_of("exx\n1\n1,2\n"), "path.csv:3:1: 2 values; expected 1, as in the header");
  EXPECT_EQ(fault_of("exx,eyy\n1,2\n1,\n"),
            R"(path.csv:3:2: value 2 is ""; expected a number (a strain, such as 1e-3))");
  EXPECT_THAT(fault_of("exx\nnan\n"), HasSubstr("path.csv:2:1: value 1 is \"nan\""));
  EXPECT_EQ(fault_of("exx\n"),
            "path.csv:1:1: no strain in the path; expected a header such as exx,eyy,gxy and one row a step");
}

TEST(Point, WritesWhatThePlaneUses) {
  const std::string text = point_csv(plastic_law(Plane::stress), Plane::stress, {{0.005, 0.005, 0, 0, 0, 0}});
  EXPECT_THAT(text, HasSubstr("exx,eyy,gxy,ezz,sxx [Pa],syy [Pa],szz [Pa],sxy [Pa],equivalent_stress "
                              "[Pa],plastic_strain,plastic_work [J/m^3],stored_energy [J/m^3]\n"));
  EXPECT_THAT(text, HasSubstr("\n0.0050000000000000001,0.0050000000000000001,0,"));
  EXPECT_THAT(text, HasSubstr(",31673306"));
  EXPECT_THAT(
      point_csv(plastic_law(Plane::none), Plane::none, {{}}), HasSubstr("exx,eyy,ezz,gxy,gyz,gzx,sxx"));
}

std::string scene_text_with(const std::string& keys, const std::string& law) {
  using namespace scene_text;
  return model("stress") + material("m", law, "210 GPa", "0.3", "7850 kg/m^3", keys + "\n") +
         box("b", "1 1 m", thick("1 m"), "m") + scene_text::time("1 s");
}
Scene scene_with(const std::string& keys, const std::string& law = "plastic") {
  return parse_scene(scene_text_with(keys, law), "scene.toml");
}
std::string scene_fault(const std::string& keys, const std::string& law = "plastic") {
  return test::faults_of(scene_text_with(keys, law), "\n");
}

TEST(PlasticMaterial, IsReadAsWritten) {
  const Scene scene = scene_with(
      "yield = \"30 MPa\"\ntangent_ratio = 0.01\ntension = \"sign\"\ntensile_strength = \"3 "
      "MPa\"\nintegration = \"no-return-3\"");
  const Plastic law = std::get<Plastic>(scene.materials.at("m").law(Plane::stress));
  EXPECT_DOUBLE_EQ(law.parameters.yield, 30e6);
  EXPECT_DOUBLE_EQ(law.parameters.hardening, 210e9 / 99);
  EXPECT_DOUBLE_EQ(law.parameters.tensile_strength, 3e6);
  EXPECT_EQ(law.parameters.tension, TensionRule::sign);
  EXPECT_EQ(law.parameters.integration, Integration::largest_stress);
  for (const char* effect : {"plasticity", "tension rule sign", "no return mapping (hypothesis 3)"})
    EXPECT_THAT(effects_on(scene), Contains(effect));
  const Scene plain = scene_with("yield = \"300 MPa\"\nhardening = \"2.12 GPa\"");
  EXPECT_DOUBLE_EQ(plain.materials.at("m").plasticity()->hardening, 2.12e9);
  EXPECT_THAT(effects_on(plain), Contains("plasticity"));
  EXPECT_THAT(effects_on(scene_with("", "elastic")), Not(Contains("plasticity")));
}

TEST(PlasticMaterial, FaultsSayWhatWasExpected) {
  const std::string either =
      "; expected one of them: \"hardening\" is H, Pa per plastic strain, \"tangent_ratio\" is r = Et/E, H = "
      "E r / (1 - r)";
  EXPECT_EQ(scene_fault("yield = \"300 MPa\""),
            "neither \"hardening\" nor \"tangent_ratio\" in [materials.m]" + either);
  EXPECT_EQ(scene_fault("yield = \"300 MPa\"\nhardening = \"0 Pa\"\ntangent_ratio = 0"),
            "both \"hardening\" and \"tangent_ratio\" in [materials.m]" + either);
  EXPECT_EQ(scene_fault("yield = \"300 MPa\"\ntangent_ratio = 1"),
            "\"tangent_ratio\" is 1; expected a number from 0 to below 1 (the tangent modulus over Young's)");
  EXPECT_THAT(scene_fault("hardening = \"1 GPa\""), HasSubstr("missing \"yield\" in [materials.m]"));
  const std::string good = "yield = \"300 MPa\"\nhardening = \"1 GPa\"\n";
  EXPECT_THAT(scene_fault(good + "tension = \"sign\""), HasSubstr("missing \"tensile_strength\""));
  EXPECT_EQ(
      scene_fault(good + "tensile_strength = \"3 MPa\""),
      "\"tensile_strength\" without a tension rule; expected tension = \"sign\" or \"principal\" with it");
  EXPECT_EQ(scene_fault(good + "integration = \"no-return\""),
            "\"integration\" is \"no-return\"; expected \"return\", \"no-return-1\", \"no-return-3\" or "
            "\"no-return-8\"; did you mean \"no-return-1\"?");
  EXPECT_THAT(
      scene_fault("yield = \"300 MPa\"", "elastic"), HasSubstr("unknown key \"yield\" in [materials.m]"));
}

}  // namespace
}  // namespace femsph::test
