// Reading of fluids and equations of state from scenes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model_faults.hpp"
#include "tests/scene_text.hpp"

namespace femsph::test {
namespace {

const std::string block_of_m =
    "[bodies.b]\nshape = \"box\"\nsize = [\"1 m\", \"1 m\", \"1 m\"]\nmaterial = "
    "\"m\"\n[time]\nduration = \"1 s\"\n";

std::string with_material(const std::string& lines, const std::string& plane = "none",
                          const std::string& motion = "large") {
  std::string text = "[model]\nplane = \"" + plane + "\"\nmotion = \"" + motion +
                     "\"\n[materials.m]\ndensity = \"1000 kg/m^3\"\n" + lines + block_of_m;
  if (plane != "none") text = scene_text::replaced(text, ", \"1 m\"]", "]\nthickness = \"1 m\"");
  return text;
}
std::string faults_with(const std::string& lines, const std::string& plane = "none",
                        const std::string& motion = "large") {
  return faults_of(with_material(lines, plane, motion), " | ");
}

const std::string of_water =
    "law = \"fluid\"\neos = {equation = \"mie-grueneisen\", c0 = \"1480 m/s\", s = 1.92, gamma0 = 0.1}\n";
const std::string of_metal =
    "law = \"plastic\"\nyoung = \"124 GPa\"\npoisson = 0.34\nyield = \"90 MPa\"\nhardening = \"0 Pa\"\n";
const std::string linear_eos = "eos = {equation = \"linear\", bulk_modulus = \"2.2 GPa\"}\n";

TEST(FluidMaterial, IsReadAsWritten) {
  const Scene scene = parse_scene(with_material("viscosity = \"1 mPa s\"\n" + of_water), "water.toml");
  const Fluid law = std::get<Fluid>(scene.materials.at("m").law(Plane::none));
  EXPECT_DOUBLE_EQ(law.parameters.eos.bulk, 1000 * 1480.0 * 1480);
  EXPECT_EQ(law.parameters.eos.s, 1.92);
  EXPECT_EQ(law.parameters.eos.gamma, 0.1);
  EXPECT_EQ(law.parameters.eos.least, 0);
  EXPECT_DOUBLE_EQ(law.parameters.viscosity, 1e-3);
  const Scene metal = parse_scene(with_material(of_metal + linear_eos), "metal.toml");
  const auto plastic = std::get<PlasticWithEos>(metal.materials.at("m").law(Plane::none));
  EXPECT_EQ(plastic.parameters.eos->bulk, 2.2e9);
  EXPECT_EQ(plastic.parameters.eos->least, -std::numeric_limits<double>::infinity());
}

TEST(FluidMaterial, FaultsSayWhatWasExpected) {
  EXPECT_EQ(faults_with(of_water), "");
  EXPECT_EQ(faults_with(of_water, "strain"), "");
  EXPECT_EQ(faults_with(of_water, "stress"),
            "\"law\" is \"fluid\" in plane stress; expected plane = \"strain\" or \"none\" in [model]");
  EXPECT_EQ(faults_with(of_water, "none", "small"),
            "\"law\" is \"fluid\" with small motion; expected motion = \"large\" in [model]");
  EXPECT_EQ(faults_with(of_water + "young = \"1 GPa\"\n"),
            "\"young\" with law = \"fluid\", which has no shear stiffness; expected the table \"eos\" alone");
  EXPECT_EQ(
      faults_with(
          "law = \"fluid\"\neos = {equation = \"linear\", bulk_modulus = \"2.2 GPa\", pressure_cutoff = "
          "\"1 MPa\"}\n"),
      "\"pressure_cutoff\" is 1e+06 Pa; expected 0 or a negative pressure (tension)");
  EXPECT_EQ(
      faults_with("law = \"fluid\"\neos = {equation = \"murnaghan\", bulk_modulus = \"2.2 GPa\", exponent = "
                  "0.5}\n"),
      "\"exponent\" is 0.5; expected a number above 1 and at most 100 (dK/dp; about 7 for water, 4 for "
      "metals)");
  EXPECT_EQ(faults_with(
                "law = \"fluid\"\neos = {equation = \"mie-grueneisen\", c0 = \"1480 m/s\", s = -1, gamma0 = "
                "0.1}\n"),
            "\"s\" is -1; expected a number from 0 to 10 (the slope of shock speed over particle speed)");
}

TEST(FluidMaterial, FaultsSayWhatWasMeant) {
  using testing::HasSubstr;
  EXPECT_THAT(faults_with("law = \"fluid\"\n"), HasSubstr("missing \"eos\""));
  EXPECT_THAT(
      faults_with("law = \"fluid\"\neoss = {equation = \"linear\"}\n"), HasSubstr("did you mean \"eos\"?"));
  EXPECT_THAT(faults_with("law = \"fluit\"\n" + linear_eos), HasSubstr("did you mean \"fluid\"?"));
  EXPECT_THAT(
      faults_with(
          "law = \"fluid\"\neos = {equation = \"murnagan\", bulk_modulus = \"1 GPa\", exponent = 7}\n"),
      HasSubstr("did you mean \"murnaghan\"?"));
  EXPECT_THAT(faults_with("law = \"fluid\"\neos = {equation = \"linear\", bulk_modulis = \"1 GPa\"}\n"),
              HasSubstr("did you mean \"bulk_modulus\"?"));
}

TEST(PlasticWithEos, FaultsSayWhatWasExpected) {
  EXPECT_EQ(faults_with(of_metal + linear_eos), "");
  EXPECT_EQ(faults_with(of_metal + linear_eos, "none", "small"),
            "\"eos\" with small motion; expected motion = \"large\" in [model]");
  EXPECT_EQ(faults_with(of_metal + linear_eos, "stress"),
            "\"eos\" in plane stress; expected plane = \"strain\" or \"none\" in [model]");
  EXPECT_EQ(faults_with(of_metal + linear_eos + "tension = \"sign\"\ntensile_strength = \"1 MPa\"\n"),
            "a tension rule with \"eos\"; expected none, or \"pressure_cutoff\" in \"eos\"");
  EXPECT_EQ(faults_with(of_metal + linear_eos + "integration = \"no-return-1\"\n"),
            "\"integration\" with \"eos\"; expected \"return\"");
}

}  // namespace
}  // namespace femsph::test
