// Faults of meaning: the file is valid TOML with known keys, but its values contradict each other or the
// mesh.

#include <gtest/gtest.h>

#include "model_faults.hpp"
#include "tests/scene_text.hpp"

using namespace femsph;

namespace {

// An L-shaped plate and whatever a test adds to it.
std::string faults_of(const std::string& addition, const std::string& time = "[time]\nduration = \"1 s\"\n") {
  using namespace scene_text;
  const std::string plate = model("strain") + steel() + R"(
[bodies.plate]
shape = "mesh"
file = "l_shape.msh"
unit = "mm"
thickness = "1 mm"
material = "steel"
)";
  return test::faults_of(plate + time + addition, "\n", FEMSPH_SOURCE_DIR "/tests/scenes/in_memory.toml");
}

const std::string second_body = R"(
[bodies.block]
shape = "box"
size = ["1 m", "1 m"]
thickness = "1 m"
material = "steel"
)";

std::string support(const std::string& place) { return "[[supports]]\nfix = [\"x\"]\n" + place; }
std::string load(const std::string& history) {
  return "[[loads]]\nat = \"x-\"\nforce = [\"1 N\", \"0 N\"]\nhistory = " + history;
}
std::string section(const std::string& keys) { return "[[sections]]\nquantity = \"stress\"\n" + keys; }

}  // namespace

TEST(SceneMeaning, ThePlateAloneIsFine) { EXPECT_EQ(faults_of(""), ""); }

TEST(SceneMeaning, Places) {
  EXPECT_EQ(faults_of(support("at = \"notch foot\"")),
            "the sides \"notch foot\" do not meet; expected sides with a common corner");
  EXPECT_EQ(faults_of(support("at = \"x+ y+\"")),
            "the sides \"x+ y+\" do not meet; expected sides with a common corner")
      << "that corner of the bounding box is cut out";
  EXPECT_EQ(faults_of(support("at = \"x+ foot\"")), "");
  EXPECT_EQ(faults_of(support("at = \"x- x-\"")), "side \"x-\" is given twice; expected each side once");
  EXPECT_EQ(faults_of(support("at = \"all x-\"")),
            "\"all\" is given with other sides; expected \"all\" alone or sides alone");
  EXPECT_EQ(faults_of(support("at = \" \"")),
            "\"at\" is empty; expected \"x-\", \"x+\", \"y-\", \"y+\", \"foot\", \"notch\" or \"all\"");
  EXPECT_EQ(faults_of(support("at = \"foto\"")),
            "unknown side \"foto\"; expected \"x-\", \"x+\", \"y-\", \"y+\", \"foot\", \"notch\" or \"all\"; "
            "did you mean \"foot\"?");
  EXPECT_EQ(faults_of(support("at = \"x-\"\npoint = [\"0 m\", \"0 m\"]")),
            "both \"at\" and \"point\" are given; expected one of them");
  EXPECT_EQ(faults_of(support("")),
            "missing \"at\" in [[supports]]; expected at = \"x-\" (sides, or \"all\") or point = [..] (the "
            "nearest point)");
  EXPECT_EQ(faults_of(support("point = [\"1.5 mm\", \"1.5 mm\"]")),
            "\"point\" lies outside body \"plate\"; expected a point of its mesh l_shape.msh of 3 "
            "quadrilaterals: x in [0, 2] mm, y in [0, "
            "2] mm");
}

TEST(SceneMeaning, BodiesByName) {
  EXPECT_EQ(faults_of(second_body + support("at = \"x-\"")),
            "missing \"body\" in [[supports]]; expected \"plate\" or \"block\"");
  EXPECT_EQ(faults_of(second_body + support("body = \"blok\"\nat = \"x-\"")),
            "unknown body \"blok\"; expected \"plate\" or \"block\"; did you mean \"block\"?");
  EXPECT_EQ(faults_of(second_body + support("body = \"block\"\nat = \"x-\"")), "");
}

TEST(SceneMeaning, Components) {
  EXPECT_EQ(faults_of("[[supports]]\nat = \"x-\"\nfix = []"),
            "\"fix\" is empty; expected a list of components such as [\"x\", \"y\"]");
  EXPECT_EQ(faults_of("[[supports]]\nat = \"x-\"\nfix = [\"y\", \"y\"]"),
            "component \"y\" is given twice; expected it once");
  EXPECT_EQ(faults_of("[gravity]\nacceleration = [\"1 m/s^2\"]"),
            "\"acceleration\" has 1 component; expected 2 (x, y) in a plane scene");
}

TEST(SceneMeaning, Histories) {
  EXPECT_EQ(faults_of(load("{time = [\"0 s\", \"1 s\"], factor = [1]}")),
            "1 factors for 2 times; expected as many factors as times");
  EXPECT_EQ(faults_of(load("{time = [], factor = []}")), "\"time\" is empty; expected at least one time");
  EXPECT_EQ(faults_of(load("{ramp = \"0 s\"}")), "\"ramp\" is 0 s; expected a time greater than zero");
  EXPECT_EQ(faults_of(load("{time = [\"0 s\"], factor = [nan]}")),
            "not a number in \"factor\"; expected a list of finite numbers");
  EXPECT_EQ(faults_of(load("\"stop\"")),
            "\"history\" is \"stop\"; expected \"step\", {ramp = \"10 ms\"} or {time = [..], factor = [..]}; "
            "did you mean \"step\"?");
}

TEST(SceneMeaning, Sections) {
  EXPECT_EQ(faults_of(section("name = \"s\"\nfrom = [\"0 mm\", \"2 mm\"]\nto = [\"2 mm\", \"0.5 mm\"]")),
            "the section leaves body \"plate\" between its ends; expected a line inside the body");
  EXPECT_EQ(faults_of(section("name = \"s\"\nfrom = [\"0 mm\", \"2 mm\"]\nto = [\"0 mm\", \"2 mm\"]")),
            "\"to\" is the same point as \"from\"; expected the other end of a line");
  EXPECT_EQ(faults_of(section(
                "name = \"a b\"\nfrom = [\"0 mm\", \"2 mm\"]\nto = [\"0 mm\", \"0 mm\"]\npoints = 10000000")),
            "the name \"a b\" cannot be used; expected letters, digits, _ and - (at most 64: it names "
            "columns and files)\n"
            "\"points\" is 10000000; expected a whole number from 2 to 1000000");
}

TEST(SceneMeaning, TimeAndSettling) {
  EXPECT_EQ(faults_of("", "[time]\n"),
            "missing \"duration\" in [time]; expected a time with its unit, such as \"50 ms\"");
  EXPECT_EQ(faults_of("", "[time]\nduration = \"1 s\"\nsamples = 1e3\n"),
            "\"samples\" is a plain number; expected a whole number from 1 to 10000000");
  EXPECT_EQ(
      faults_of(load("\"step\"\n[settling]\nmethod = \"kinetic\"\nrate = \"1 1/s\"\ntolerance = 1")),
      "\"rate\" with method = \"kinetic\", which damps nothing; expected it only with method = \"damping\"\n"
      "\"tolerance\" is 1; expected a number above 0 and below 1");
}
