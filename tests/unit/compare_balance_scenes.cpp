// Forces and moments add up at every sample, for each kind of load and support, by every method.

#include "compare_balance_support.hpp"

namespace femsph::compare {
namespace {

using namespace test;  // of compare_balance_support.hpp
using namespace scene_text;

TEST(Balance, ForcesAddUpInEveryScene) {
  const std::string weight = gravity("3 -10 m/s^2"), end = scene_text::time("4 ms", "samples = 8\n");
  const std::string held = support("x-", "x y"), foot = support("y-", "x y", of_body("b"));
  const std::string above = box("c", "2 1 m", origin("0 1 m") + thick("1 m"), "m");
  const std::string pull = load("x+", "1 -2 kN");
  const std::vector<std::pair<std::string, std::string>> scenes = {
      {"loads", held + load("x+", "1 -2 kN", "history = {ramp = \"3 ms\"}\n") +
                    "[[loads]]\nat = \"y+\"\npressure = \"1 kPa\"\n"},
      {"mean", support("x-", "x y", "mode = \"mean\"\n") + pull},
      {"driven", held + support("x+", "y", velocity("0 0.1 m/s")) + "[damping]\nrate = \"100 1/s\"\n"},
      {"symmetry", "[[symmetry]]\nat = \"x-\"\n" + support("y-", "y")},
      {"tied", above + foot + contact("b", "c", "kind = \"tied\"\n")},
      {"contact", above + foot + contact("b", "c", "friction = 0.3\n")},
      {"rigid",
       "[bodies.w]\nshape = \"box\"\nsize = [\"1 m\", \"1 m\"]\n" + origin("0.5 1 m") + rigid("500 kg") +
           "[[supports]]\nbody = \"w\"\nfix = [\"x\"]\n" + foot + contact("w", "b", "friction = 0.3\n")}};
  for (const auto& [name, text] : scenes)
    for (const bool large : {false, true})
      for (const Method& method : methods()) {
        const bool virtual_only_small = !method.is_fem() && method.name != "sph-corrected" &&
                                        name == "symmetry";
        if (virtual_only_small ||
            (large && (name == "loads" || method.name == "sph-virtual" || method.name == "sph-weight")))
          continue;
        std::string whole = block(text + weight + end);
        if (large) whole = replaced(whole, "plane", large_motion + "plane");
        RunResult r;
        try {
          r = run_scene(balance_scene(whole), method, {0.25, {}}, {});
        } catch (const std::exception& error) {
          ADD_FAILURE() << name << " " << method.name << ": " << error.what();
          continue;
        }
        EXPECT_LT(r.balance.force, 1e-11) << name << " " << method.name << (large ? " large" : "");
        const bool keeps_moments = method.is_fem() || method.name == "sph-corrected";
        if (keeps_moments) {
          EXPECT_LT(r.balance.moment, 1e-11) << name << " " << method.name << (large ? " large" : "");
        }
        EXPECT_THAT(r.warnings, ::testing::Not(::testing::Contains(::testing::HasSubstr("do not add up"))))
            << name << " " << method.name;
      }
}

}  // namespace
}  // namespace femsph::compare
