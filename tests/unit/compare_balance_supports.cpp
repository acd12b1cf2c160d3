// Supports that share points: the reaction of a shared point counts once; supports that contradict each other
// are refused.

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "compare_balance_support.hpp"

namespace femsph::compare {
namespace {

using namespace test;  // of compare_balance_support.hpp
using namespace scene_text;
using ::testing::AllOf, ::testing::HasSubstr, ::testing::ThrowsMessage;
// A block of 20 kN held in y along its foot and in x and y along its side: the corner belongs to both, and
// counts once.
TEST(Balance, SupportsThatShareACornerShareItsReaction) {
  const std::string rest = support("y-", "y", named("foot")) + support("x-", "x y", named("side")) +
                           gravity("0 -10 m/s^2") + settling("damping", "tolerance = 1e-6\n") +
                           scene_text::time("0.5 s", "samples = 5\n");
  for (const char* method : {"fem-full", "sph-corrected"})
    for (const double d : {0.5, 0.125}) {
      const RunResult r = run_scene(balance_scene(block(rest)), method_named(method), {d, {}}, {});
      ASSERT_TRUE(r.settled) << method;
      EXPECT_NEAR(column(r, "support_foot_force_y").back() + column(r, "support_side_force_y").back(), 20000,
                  1e-6 * 2 * 20000)
          << method << d;
      EXPECT_GT(column(r, "support_side_force_y").back(), 100) << method << d;
      EXPECT_LT(r.balance.force, 1e-12) << method << d;
    }
}

// A bar of quadrilaterals, fine at the lower edge and coarse at the upper one, pulled at its right end by a
// traction: no moment at the left.
TEST(Balance, CentricPullOnAGradedFaceHasNoMoment) {
  const std::vector<double> y{0, 0.02, 0.05, 0.1, 0.2, 0.4, 1};
  std::string nodes, cells;
  const int n = int(y.size()), m = 9;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j)
      nodes += std::to_string(i * n + j + 1) + " " + std::to_string(2.0 * i / (m - 1)) + " " +
               std::to_string(y[std::size_t(j)]) + " 0\n";
  int count = 0;
  const auto edge = [&](int tag, int a, int b) {
    cells += std::to_string(++count) + " 1 2 " + std::to_string(tag) + " " + std::to_string(tag) + " " +
             std::to_string(a) + " " + std::to_string(b) + "\n";
  };
  for (int j = 1; j < n; ++j) edge(1, j, j + 1), edge(2, (m - 1) * n + j, (m - 1) * n + j + 1);
  for (int i = 0; i + 1 < m; ++i)
    for (int j = 1; j < n; ++j) {
      const int a = i * n + j;
      cells += std::to_string(++count) + " 3 2 3 1 " + std::to_string(a) + " " + std::to_string(a + n) + " " +
               std::to_string(a + n + 1) + " " + std::to_string(a + 1) + "\n";
    }
  const std::string file =
      (std::filesystem::temp_directory_path() / ("graded-" + std::to_string(::getpid()) + ".msh")).string();
  std::ofstream(file) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"clamp\"\n1 2 "
                         "\"pull\"\n2 3 \"bar\"\n$EndPhysicalNames\n$Nodes\n"
                      << n * m << "\n"
                      << nodes << "$EndNodes\n$Elements\n"
                      << count << "\n"
                      << cells << "$EndElements\n";
  const RunResult r = run_scene(
      balance_scene(model("stress") + material("m", "elastic", "1 GPa", "0.0", "1000 kg/m^3") +
                    "[bodies.b]\nshape = \"mesh\"\nfile = \"" + file +
                    "\"\nunit = \"m\"\nthickness = \"1 m\"\nmaterial = \"m\"\n" +
                    support("clamp", "x y", named("foot")) + load("pull", "1 0 MN") +
                    settling("damping", "tolerance = 1e-6\n") + scene_text::time("0.5 s", "samples = 5\n")),
      method_named("fem-full"), {}, {});
  std::filesystem::remove(file);
  ASSERT_TRUE(r.settled) << ::testing::PrintToString(r.warnings);
  EXPECT_NEAR(column(r, "support_foot_force_x").back(), -1e6, 2);
  EXPECT_NEAR(column(r, "support_foot_moment_z").back(), 0, 1e6 * 1e-5);
  EXPECT_NEAR(column(r, "support_foot_centroid_x").back(), 0, 1e-12);
  EXPECT_NEAR(column(r, "support_foot_centroid_y").back(), 0.5, 1e-9);  // not the mean of the nodes, 0.25
  const auto said = std::find_if(
      r.derived.begin(), r.derived.end(), [](const auto& value) { return value.first == "support foot"; });
  ASSERT_NE(said, r.derived.end());
  EXPECT_THAT(said->second, HasSubstr("(0, 0.5, 0) m"));
}

TEST(Balance, SupportsThatContradictEachOtherAreRefused) {
  const std::string foot = support("y-", "x y"), end = scene_text::time("1 ms");
  const auto push = [](const char* speed, const char* more = "") {
    return support("x+", "x", velocity(std::string(speed) + " 0 m/s") + more);
  };
  const auto run = [&](const std::string& rest) {
    return run_scene(balance_scene(block(rest + end)), method_named("fem-full"), {0.5, {}}, {});
  };
  EXPECT_THAT(
      [&] { run(foot + push("1")); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("balance.toml:17:6: this support moves it at 1 m/s along x "
                                                "and the one at balance.toml:14:6 holds it at rest"),
                                      HasSubstr("both have the point (2, 0, 0) m of body \"b\""))));
  EXPECT_THAT(
      [&] { run(push("1") + support("y+", "x", velocity("2 0 m/s"))); },
      ThrowsMessage<InputError>(HasSubstr(
          "this support moves it at 2 m/s along x and the one at balance.toml:14:6 moves it at 1 m/s")));
  EXPECT_THAT(
      [&] { run(push("1") + "[[symmetry]]\nat = \"x+\"\n"); },
      ThrowsMessage<InputError>(HasSubstr("balance.toml:18:6: this support holds it at rest along x")));
  EXPECT_THAT(
      [&] { run(push("1", "history = {ramp = \"1 ms\"}\n") + support("y+", "x", velocity("1 0 m/s"))); },
      ThrowsMessage<InputError>(HasSubstr("moves it at 1 m/s times its history")));
  EXPECT_THAT([&] { run(push("1") + support("y+", "x", "mode = \"mean\"\n")); },
              ThrowsMessage<InputError>(HasSubstr("holds the mean along x of a place of body \"b\" where the "
                                                  "one at balance.toml:14:6 moves points")));
  EXPECT_NO_THROW(run(push("1") + support("y+", "x y", velocity("1 0 m/s")))) << "they agree";
  EXPECT_NO_THROW(run(foot + support("x-", "x") + load("x+", "1 0 N"))) << "they agree";
}

TEST(Balance, NamesThatMeetInAColumnAreRefused) {
  EXPECT_THAT(
      [] {
        run_scene(balance_scene(
                      block(support("x-", "x", named("foot")) +
                            probe("support_foot_force", "displacement", "1 0 m") + scene_text::time("1 ms"))),
                  method_named("fem-full"), {0.5, {}}, {});
      },
      ThrowsMessage<InputError>(HasSubstr("the history would have two columns \"support_foot_force_x\"")));
}

}  // namespace
}  // namespace femsph::compare
