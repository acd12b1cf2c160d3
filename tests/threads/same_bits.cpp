// The same result to the last bit on 1, 2 and 3 threads and on a second run: histories, displacements,
// velocities, forces and the state of the material. Scenes hold 8192 units and more, below which loops stay
// on one thread. Under the thread sanitizer each runs once, on 3 threads.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "compare/run/run.hpp"
#include "model/numerics/parallel.hpp"
#include "model/results/recorder.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph {
namespace {

#ifdef FEMSPH_SANITIZED
constexpr bool watched = true;
#else
constexpr bool watched = false;
#endif

using Bits = std::vector<double>;

Bits run(const Scene& scene, const std::string& method, double spacing, int threads) {
  set_threads(threads);
  std::vector<std::unique_ptr<Discretization>> bodies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (!scene.bodies[b].rigid)
      bodies.push_back(compare::discretize(scene, b, compare::method_named(method), {spacing, {}}));
  March march(scene, std::move(bodies), {});
  Recorder recorder(march);
  MarchEvents events;
  events.sample = [&](const March& m) { recorder.sample(m); };
  march.run(events);
  set_threads(1);
  Bits all;
  for (const auto& column : recorder.history().columns)
    all.insert(all.end(), column.values.begin(), column.values.end());
  for (const MovingBody& body : march.bodies()) {
    const Discretization& d = *body.discretization;
    for (const auto* field : {&body.u, &body.v, &body.f}) all.insert(all.end(), field->begin(), field->end());
    std::vector<std::size_t> points(d.material_points());
    std::iota(points.begin(), points.end(), 0);
    MaterialState state;
    d.material_state(body.u.data(), points, state);
    for (const auto* tensors : {&state.stress, &state.strain})
      for (const auto& t : *tensors) all.insert(all.end(), t.begin(), t.end());
    all.insert(all.end(), state.plastic.begin(), state.plastic.end());
  }
  return all;
}

void expect_same_bits(const Scene& scene, const std::string& method, double spacing) {
  if (watched) {
    run(scene, method, spacing, 3);
    return;
  }
  const Bits one = run(scene, method, spacing, 1);
  double size = 0;
  for (const double x : one) size += std::abs(x);
  EXPECT_GT(size, 0) << method;  // something has moved
  for (const int threads : {1, 2, 3}) {
    const Bits again = run(scene, method, spacing, threads);
    ASSERT_EQ(again.size(), one.size()) << method;
    std::size_t differ = 0;
    for (std::size_t i = 0; i < one.size(); ++i) differ += !(again[i] == one[i]);  // nan too
    EXPECT_EQ(differ, 0u) << method << " on " << threads << " threads, of " << one.size();
  }
}

const std::string elastic = "law = \"elastic\"\n",
                  plastic = "law = \"plastic\"\nyield = \"20 MPa\"\ntangent_ratio = 0.01\n";

std::string material(const std::string& law) {
  return "[materials.steel]\nyoung = \"210 GPa\"\npoisson = 0.3\ndensity = \"7850 kg/m^3\"\n" + law;
}

/// A cantilever of about 300 x 30 cells at 3.33 mm, bent by its own weight and a load; 30 steps.
Scene cantilever(const std::string& law, const std::string& motion, const std::string& rest = "") {
  return parse_scene(
      "[model]\nplane = \"stress\"\nmotion = \"" + motion + "\"\n" + material(law) +
          "[bodies.beam]\nshape = \"box\"\nsize = [\"1000 mm\", \"100 mm\"]\nthickness = \"100 "
          "mm\"\nmaterial = \"steel\"\n"
          "[[supports]]\nat = \"x-\"\nfix = [\"x\", \"y\"]\n[[loads]]\nat = \"x+\"\nforce = [\"3 MN\", \"-3 "
          "MN\"]\n"
          "[[probes]]\nname = \"tip\"\nquantity = \"displacement\"\npoint = [\"1000 mm\", \"50 mm\"]\n"
          "[gravity]\nacceleration = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n[time]\nduration = \"15 us\"\nsamples = "
          "10\n" +
          rest,
      "cantilever.toml");
}

TEST(SameBits, EveryMethod) {
  for (const compare::Method& method : compare::methods())
    if (!watched || method.name == "fem-full" || method.name == "fem-one-point" ||
        method.name == "sph-corrected" || method.name == "sph-virtual")
      expect_same_bits(cantilever(elastic, "small"), method.name, 100e-3 / 30);
}

TEST(SameBits, LargeMotionAndPlasticity) {
  for (const compare::Method& method : compare::methods())
    if (method.name != "sph-virtual" &&
        method.name != "sph-weight" &&  // these stand on initial neighbours and refuse large motion
        (!watched || method.name == "fem-full" || method.name == "fem-assumed-strain" ||
         method.name == "sph-corrected"))
      expect_same_bits(cantilever(plastic, "large"), method.name, 100e-3 / 30);
}

TEST(SameBits, SettlingAndDamping) {
  const std::string settling = "[settling]\nmethod = \"damping\"\n";
  for (const char* method : {"fem-full", "sph-corrected"})
    expect_same_bits(cantilever(elastic, "small", settling), method, 100e-3 / 30);
}

/// Two blocks of about 92 x 92 units meet at 20 m/s, one of them turning, with friction; a third is tied to
/// the upper one.
TEST(SameBits, ContactAndTies) {
  const auto block = [](const char* name, const char* origin, const char* size) {
    return fmt::format(
        "[bodies.{}]\nshape = \"box\"\norigin = [{}]\nsize = [{}]\nthickness = \"10 mm\"\nmaterial = "
        "\"steel\"\n",
        name, origin, size);
  };
  const Scene scene = parse_scene(
      "[model]\nplane = \"stress\"\nmotion = \"large\"\n" + material(elastic) +
          block("lower", "\"0 mm\", \"0 mm\"", "\"100 mm\", \"100 mm\"") +
          block("upper", "\"3 mm\", \"100 mm\"", "\"95 mm\", \"95 mm\"") +
          block("top", "\"3 mm\", \"195 mm\"", "\"95 mm\", \"5 mm\"") +
          "[[initial]]\nbody = \"upper\"\nvelocity = [\"2 m/s\", \"-20 m/s\"]\n[[initial]]\nbody "
          "= \"top\"\nvelocity = [\"2 m/s\", \"-20 m/s\"]\n"
          "[[contacts]]\nbetween = [\"lower\", \"upper\"]\nfriction = 0.2\n[[contacts]]\nkind = "
          "\"tied\"\nbetween = [\"top\", \"upper\"]\n"
          "[time]\nduration = \"6 us\"\nsamples = 10\n",
      "blocks.toml");
  for (const char* method : {"fem-full", "sph-corrected"}) expect_same_bits(scene, method, 100e-3 / 92);
}

TEST(SameBits, ContactInSpace) {
  const auto block = [](const char* name, const char* origin) {
    return fmt::format(
        "[bodies.{}]\nshape = \"box\"\norigin = [{}]\nsize = [\"22 mm\", \"22 mm\", \"20 mm\"]\nmaterial = "
        "\"steel\"\n",
        name, origin);
  };
  const Scene scene = parse_scene(
      "[model]\nplane = \"none\"\nmotion = \"large\"\n" + material(elastic) +
          block("lower", "\"0 mm\", \"0 mm\", \"0 mm\"") + block("upper", "\"1.3 mm\", \"0 mm\", \"20 mm\"") +
          "[[initial]]\nbody = \"upper\"\nvelocity = [\"2 m/s\", \"0 m/s\", \"-20 "
          "m/s\"]\n[[contacts]]\nbetween = [\"lower\", \"upper\"]\nfriction = 0.2\n"
          "[time]\nduration = \"2 us\"\nsamples = 5\n",
      "blocks.toml");
  for (const char* method : {"fem-full", "sph-corrected"}) expect_same_bits(scene, method, 1e-3);
}

}  // namespace
}  // namespace femsph
