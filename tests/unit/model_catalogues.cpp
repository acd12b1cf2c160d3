// The catalogues of laws and shapes: the reader takes their words, and an entry states what its law or shape
// does.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "model/material/material.hpp"
#include "model/scene/shapes/shapes.hpp"
#include "model_faults.hpp"
#include "tests/scene_text.hpp"

namespace femsph {
namespace {

using testing::HasSubstr;

std::string weight_and_beam(const std::string& law, const std::string& weight, const std::string& more = "") {
  using namespace scene_text;
  return model("strain", large_motion) +
         replaced(material("m", "LAW", "210 GPa", "0.3", "7850 kg/m^3"), "\"LAW\"", law) +
         "[bodies.weight]\n" + rigid("1 kg") + weight + box("beam", "1000 100 mm", thick("100 mm"), "m") +
         scene_text::time("1 ms") + more;
}
const std::string disc = "shape = \"disc\"\ncentre = [\"0 mm\", \"200 mm\"]\nradius = \"100 mm\"\n";

using test::message_of;

template <class Entries>
void expect_complete(const Entries& entries) {
  std::set<std::string> words;
  for (const auto& e : entries) {
    EXPECT_TRUE(words.insert(e.entry.word).second) << e.entry.word << " twice";
    EXPECT_FALSE(e.entry.about.empty()) << e.entry.word;
    std::set<std::string> keys;
    for (const Key& key : e.entry.keys) {
      EXPECT_TRUE(keys.insert(key.name).second) << e.entry.word << ": " << key.name << " twice";
      EXPECT_FALSE(key.holds.empty()) << e.entry.word << ": " << key.name;
    }
  }
}

TEST(Catalogue, WordsAndKeysAreStatedOnce) {
  expect_complete(laws());
  expect_complete(shapes());
}

// Entry i is of alternative i: its parameters give a law of the same index.
TEST(Catalogue, EntriesOfLawsStandInTheOrderOfTheVariant) {
  ASSERT_EQ(laws().size(), std::variant_size_v<LawParameters>);
  const std::vector<LawParameters> all = {
      LinearElastic::Parameters{}, NeoHookean::Parameters{}, Plasticity{1e6, 0}, Fluid::Parameters{}};
  ASSERT_EQ(laws().size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Material m{"m", 1e9, 0.3, 1000, all[i]};
    EXPECT_EQ(all[i].index(), i);
    EXPECT_EQ(m.law(Plane::strain).index(), i) << laws()[i].entry.word;
  }
  // The one law that is chosen by its parameters.
  Plasticity with_eos{1e6, 0};
  with_eos.eos = EquationOfState{};
  EXPECT_TRUE(
      std::holds_alternative<PlasticWithEos>(Material{"m", 1e9, 0.3, 1000, with_eos}.law(Plane::strain)));
}

TEST(Catalogue, MaterialsStateTheirLaws) {
  const Material elastic{"m", 1e9, 0.3, 1000}, rubber{"m", 1e9, 0.3, 1000, NeoHookean::Parameters{}},
      metal{"m", 1e9, 0.3, 1000, Plasticity{1e6, 0}}, hard{"m", 1e9, 0.3, 1000, Plasticity{1e6, 1e7}};
  EXPECT_TRUE(elastic.is_linear_elastic());
  EXPECT_FALSE(rubber.is_linear_elastic() || metal.is_linear_elastic());
  EXPECT_FALSE(elastic.yields() || rubber.yields());
  EXPECT_TRUE(metal.yields());
  EXPECT_EQ(rubber.plasticity(), nullptr);
  EXPECT_TRUE(metal.plasticity()->perfect());
  EXPECT_FALSE(hard.plasticity()->perfect());
  EXPECT_EQ(rubber.effects(), std::vector<std::string>{"neo-Hookean law"});
  EXPECT_TRUE(elastic.effects().empty());
  EXPECT_EQ(hard.bar().hardening, 1e7);
  EXPECT_EQ(rubber.bar().refusal, "");
  const Material water{"m", 0, 0.5, 1000, Fluid::Parameters{}};
  EXPECT_TRUE(water.is_fluid());
  EXPECT_FALSE(metal.is_fluid());
  EXPECT_EQ(water.bar().refusal,
            "has the law \"fluid\", which bars do not; expected \"elastic\", \"neo-hookean\" or \"plastic\"");
}

TEST(Catalogue, AMisspeltWordGetsASuggestion) {
  EXPECT_EQ(message_of(weight_and_beam("\"neo-hookian\"", disc)),
            "scene.toml:5:7: \"law\" is \"neo-hookian\"; expected \"elastic\", \"neo-hookean\", \"plastic\" "
            "or \"fluid\"; did you mean \"neo-hookean\"?");
  EXPECT_THAT(message_of(weight_and_beam("\"elastic\"", "shape = \"quadrilatral\"\n")),
              HasSubstr("did you mean \"quadrilateral\"?"));
}

// Contact knows the surfaces of rigid boxes, discs and spheres only.
TEST(Catalogue, OtherShapesCannotBeRigid) {
  EXPECT_EQ(message_of(weight_and_beam("\"elastic\"", disc)), "");
  EXPECT_EQ(message_of(weight_and_beam(
                "\"elastic\"",
                "shape = \"ring\"\ncentre = [\"0 m\", \"1 m\"]\ninner = \"1 mm\"\nouter = \"2 mm\"\n")),
            "scene.toml:12:9: a rigid ring of radii 1 and 2 mm; expected \"box\", \"disc\" or \"sphere\"");
}

TEST(Catalogue, BarsRefuseWhatTheirLawCannotDo) {
  const std::string bar =
      "[bars.rod]\nbody = \"beam\"\nfrom = [\"0 m\", \"50 mm\"]\nto = [\"1 m\", \"50 mm\"]\n"
      "area = \"1 mm^2\"\nmaterial = \"m\"\n";
  EXPECT_EQ(message_of(weight_and_beam("\"neo-hookean\"", disc, bar)), "");
  EXPECT_THAT(
      message_of(weight_and_beam(
          "\"plastic\"\nyield = \"1 GPa\"\njohnson_cook = {B = \"1 GPa\", n = 0.5}", disc, bar)),
      HasSubstr("material \"m\" hardens by Johnson-Cook, which bars do not; expected \"hardening\" or "
                "\"tangent_ratio\""));
}

}  // namespace
}  // namespace femsph
