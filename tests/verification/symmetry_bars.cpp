// Symmetry planes, supports that may turn, and bars, by both solvers against beam theory and against whole
// models.

#include <gtest/gtest.h>

#include <numeric>

#include "model/motion/effects/mean_supports.hpp"
#include "model/results/recorder.hpp"
#include "support.hpp"

namespace femsph::test {
namespace {

struct Beam {
  std::string size, parts, young = "25 GPa", poisson = "0";
  const char* plane = "stress";
  std::string rebar = "law = \"elastic\"";  ///< or a plastic law
};

/// A box of concrete with whatever else a test gives; materials "concrete" and "rebar" (200 GPa).
Scene scene_of(const Beam& b, const std::string& end) {
  return parse_scene(fmt::format(R"(
title = "reinforced beam"
[model]
plane = "{}"
[materials.concrete]
law = "elastic"
young = "{}"
poisson = {}
density = "2400 kg/m^3"
[materials.rebar]
{}
young = "200 GPa"
poisson = 0.3
density = "7850 kg/m^3"
[bodies.beam]
shape = "box"
{}
material = "concrete"
{}
{})",
                                 b.plane, b.young, b.poisson, b.rebar, b.size, b.parts, end),
                     "beam.toml");
}

/// A finished march, to look into its end state.
struct Marched {
  Marched(const Scene& s, const std::string& method, double spacing_mm, std::optional<double> step = {})
      : scene(s) {
    std::vector<std::unique_ptr<Discretization>> bodies;
    bodies.push_back(compare::discretize(scene, 0, compare::method_named(method), {spacing_mm * 1e-3, {}}));
    MarchOptions options;
    options.step = step;
    march = std::make_unique<March>(scene, std::move(bodies), options);
    recorder = std::make_unique<Recorder>(*march);
    MarchEvents events;
    events.sample = [&](const March& m) {
      recorder->sample(m);
      const Ledger l = m.ledger();
      supplied = std::max(supplied, std::abs(l.external) + l.initial);
      worst_balance = std::max(worst_balance, std::abs(l.imbalance()));
    };
    march->run(events);
  }
  const Discretization& body() const { return *march->bodies()[0].discretization; }
  double end(const std::string& column) const { return recorder->history()[column].values.back(); }
  double balance() const { return worst_balance / supplied; }
  std::vector<BarPiece> bars() const { return body().bars(march->bodies()[0].u.data()); }
  Scene scene;
  std::unique_ptr<March> march;
  std::unique_ptr<Recorder> recorder;
  double supplied = 0, worst_balance = 0;
};

std::string probe(const char* name, const char* quantity, const std::string& point) {
  return fmt::format("[[probes]]\nname = \"{}\"\nquantity = \"{}\"\npoint = [{}]\n", name, quantity, point);
}

// Impact-like load on a simply supported beam with a bar: the half model's midspan and end move as the
// whole's, at the same step. Both add the same numbers in different orders: round-off, which the motion
// amplifies by the number of steps at most.
TEST(Symmetry, HalfBeamMovesAsTheWhole) {
  const auto beam = [](bool half, double step) {
    const std::string bar =
        "[bars.bottom]\nfrom = [\"{} mm\", \"24 mm\"]\nto = [\"200 mm\", \"24 mm\"]\narea = \"500 "
        "mm^2\"\nmaterial = \"rebar\"\n";
    const std::string support =
        "[[supports]]\nat = \"y-\"\nwithin = [[\"{} mm\", \"0 mm\"], [\"{} mm\", \"0 mm\"]]\nfix = "
        "[\"y\"]\nmode = \"mean\"\n";
    const std::string load =
        "[[loads]]\nat = \"y+\"\nwithin = [[\"{} mm\", \"80 mm\"], [\"40 mm\", \"80 mm\"]]\nforce = [\"0 "
        "N\", \"-{} kN\"]\n";
    Beam b;
    b.poisson = "0.2";
    b.size = fmt::format(
        "size = [\"{} mm\", \"80 mm\"]\norigin = [\"{} mm\", \"0 mm\"]\nthickness = \"100 mm\"",
        half ? 200 : 400, half ? 0 : -200);
    b.parts = fmt::format(fmt::runtime(bar), half ? 0 : -200) + fmt::format(fmt::runtime(support), 140, 180) +
              fmt::format(fmt::runtime(load), half ? 0 : -40, half ? 10 : 20);
    b.parts += half ? "[[symmetry]]\nat = \"x-\"\n" : fmt::format(fmt::runtime(support), -180, -140);
    b.parts += probe("mid", "displacement", "\"0 mm\", \"0 mm\"") +
               probe("end", "displacement", "\"200 mm\", \"80 mm\"") +
               probe("stress", "stress", "\"0 mm\", \"40 mm\"") +
               "reading = \"raw\"\n";  // the particle's own: the rule's patch ends at the plane
    return scene_of(b, fmt::format("[time]\nduration = \"{} s\"\nsamples = 100\n", 400 * step));
  };
  for (const char* method : {"fem-full", "fem-assumed-strain", "fem-one-point", "sph-classic-share",
                             "sph-classic-full", "sph-classic-trapezoid", "sph-weight", "sph-corrected"}) {
    const double step = 8e-7;
    const Marched half(beam(true, step), method, 10, step), whole(beam(false, step), method, 10, step);
    const auto &h = half.recorder->history(), &w = whole.recorder->history();
    for (const char* column : {"mid_y", "end_x", "end_y", "stress_xx"}) {
      if (std::string(method).starts_with("fem") && column[0] == 's')
        continue;  // read from the cells of one side
      const auto &a = h[column].values, &b = w[column].values;
      ASSERT_EQ(a.size(), b.size());
      double peak = 0, apart = 0;
      for (std::size_t k = 0; k < a.size(); ++k)
        peak = std::max(peak, std::abs(b[k])), apart = std::max(apart, std::abs(a[k] - b[k]));
      EXPECT_LT(apart, 1e-9 * peak) << method << " " << column;
      EXPECT_GT(peak, 0);
    }
    EXPECT_NEAR(2 * half.march->ledger().kinetic, whole.march->ledger().kinetic,
                1e-8 * whole.march->ledger().external)
        << method;
    EXPECT_NEAR(
        half.march->critical_step(), whole.march->critical_step(), 0.02 * whole.march->critical_step())
        << method;
    EXPECT_LT(half.balance(), 1e-9) << method;
    EXPECT_LT(half.march->force_imbalance(), 1e-11) << method;
  }
}

/// Half of a simply supported beam, 1000 mm of 2000 mm between supports, 100 mm high and thick; half of the
/// midspan load, F = 1 kN, comes in over the symmetry plane, the support is the mean of the end face. Probes:
/// deflection, end rotation.
Beam half_span(const std::string& more) {
  Beam b;
  b.size = "size = [\"1000 mm\", \"100 mm\"]\norigin = [\"0 mm\", \"-50 mm\"]\nthickness = \"100 mm\"";
  b.parts =
      "[[symmetry]]\nat = \"x-\"\n[[supports]]\nat = \"x+\"\nfix = [\"y\"]\nmode = \"mean\"\n[[loads]]\nat = "
      "\"x-\"\nforce = [\"0 N\", \"-1 kN\"]\n" +
      more + probe("mid", "displacement", "\"0 mm\", \"0 mm\"") +
      probe("top", "displacement", "\"1000 mm\", \"50 mm\"") +
      probe("bottom", "displacement", "\"1000 mm\", \"-50 mm\"") +
      probe("axis", "displacement", "\"1000 mm\", \"0 mm\"");
  return b;
}

// Simply supported, central load 2 F on a span 2 L: deflection F L^3 / (3 E I) + F L / (5/6 G A), rotation F
// L^2 / (2 E I) at the end.
TEST(MeanSupport, TurnsFreelyAndHoldsItsMean) {
  const double E = 25e9, I = 0.1 * 1e-3 / 12, A = 0.01, F = 1e3;
  const double deflection = F / (3 * E * I) + F / (5.0 / 6 * E / 2 * A), rotation = F / (2 * E * I);
  for (const auto& [method, d] : {std::pair("fem-assumed-strain", 20.0), std::pair("sph-corrected", 5.0)}) {
    const Marched r(scene_of(half_span(""), settle), method, d);
    EXPECT_NEAR(error(-r.end("mid_y"), deflection), 0, 2) << method;
    EXPECT_NEAR(error((r.end("bottom_x") - r.end("top_x")) / 0.1, rotation), 0, 2) << method;
    Place end;
    end.sides = {"x+"};
    double mean = 0, largest = 0;
    for (const Weight& w : r.body().points_of(end)) {
      const double u = r.march->bodies()[0].u[r.body().layout().at(w.point, 1)];
      mean += w.weight * u;
      largest = std::max(largest, std::abs(u));
    }
    EXPECT_LT(std::abs(mean), 1e-11 * deflection) << method;
    EXPECT_GT(largest, 1e-6 * deflection) << method;
    double reaction = 0;
    for (const MeanSupports::MeanHold& hold : r.march->effects().find<MeanSupports>()->holds())
      reaction += hold.reaction;
    EXPECT_NEAR(reaction, F, 1e-3 * F) << method;
  }
}

// Tension F on a bar of concrete with steel in its middle row. Far from the ends the strain is F / (E A + E_b
// A_b), the stresses are in the ratio of the moduli, and the forces in a section sum to F.
TEST(Bars, ShareTensionByTheirModuli) {
  Beam b;
  b.size = "size = [\"600 mm\", \"100 mm\"]\norigin = [\"0 mm\", \"-50 mm\"]\nthickness = \"100 mm\"";
  b.parts =
      "[[symmetry]]\nat = \"x-\"\n[[supports]]\npoint = [\"0 mm\", \"0 mm\"]\nfix = [\"y\"]\n[[loads]]\nat = "
      "\"x+\"\nforce = [\"100 kN\", \"0 N\"]\n"
      "[bars.middle]\nfrom = [\"0 mm\", \"0 mm\"]\nto = [\"600 mm\", \"0 mm\"]\narea = \"250 "
      "mm^2\"\nmaterial = \"rebar\"\n" +
      probe("matrix", "stress", "\"100 mm\", \"0 mm\"");
  const double E = 25e9, Eb = 200e9, A = 0.01, Ab = 250e-6, F = 100e3, strain = F / (E * A + Eb * Ab);
  for (const char* method : {"fem-full", "fem-assumed-strain", "sph-corrected", "sph-classic-trapezoid"}) {
    const Marched r(scene_of(b, settle), method, 10);
    const bool exact = std::string(method) != "sph-classic-trapezoid";
    double bar_force = 0, bar_stress = 0, near = 1;
    for (const BarPiece& p : r.bars()) {
      if (std::abs(p.position[0] - 0.1) < near - 1e-9)
        near = std::abs(p.position[0] - 0.1), bar_stress = p.stress, bar_force = p.stress * p.area;
    }
    EXPECT_NEAR(error(bar_stress / r.end("matrix_xx"), Eb / E), 0, exact ? 0.2 : 1) << method;
    // The section's mean over the slice 60 mm < x < 140 mm.
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < r.body().material_points(); ++i)
      if (std::abs(r.body().material_position(i)[0] - 0.1) < 0.0351) points.push_back(i);
    MaterialState state;
    r.body().material_state(r.march->bodies()[0].u.data(), points, state);
    double force = 0, volume = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      force += state.stress[k][0] * r.body().material_volume(points[k]);
      volume += r.body().material_volume(points[k]);
    }
    const double matrix_force = force / volume * A;
    fmt::print("{}: strain {:+.3f} %, force balance {:+.3f} %\n", method, error(bar_stress / Eb, strain),
               error(matrix_force + bar_force, F));
    EXPECT_NEAR(error(bar_stress / Eb, strain), 0, exact ? 0.5 : 12) << method;
    EXPECT_NEAR(error(matrix_force + bar_force, F), 0, exact ? 0.5 : 12) << method;
  }
}

// Bars at 40 mm below and above the axis, 500 mm^2 each: E I = E b h^3/12 + 2 E_b A_b y^2 (the body keeps its
// own area). At d = 20 mm they lie between rows and are shared, at 10 and 5 mm they lie on rows.
TEST(Bars, BendAsTheTransformedSection) {
  const auto bar = [](const char* name, int y) {
    return fmt::format(
        "[bars.{}]\nfrom = [\"0 mm\", \"{} mm\"]\nto = [\"1000 mm\", \"{} mm\"]\narea = \"500 "
        "mm^2\"\nmaterial = \"rebar\"\n",
        name, y, y);
  };
  const double E = 25e9, Eb = 200e9, A = 0.01, F = 1e3;
  const double both = E * 0.1 * 1e-3 / 12 + 2 * Eb * 500e-6 * 0.04 * 0.04;
  const double EA = E * A + Eb * 500e-6, shift = -0.04 * Eb * 500e-6 / EA;
  const double one = E * (0.1 * 1e-3 / 12 + A * shift * shift) +
                     Eb * 500e-6 * (0.04 + shift) * (0.04 + shift);
  const auto deflection = [&](double EI) { return F / (3 * EI) + F / (5.0 / 6 * E / 2 * A); };
  for (const std::string method : {"fem-assumed-strain", "sph-corrected"}) {
    std::vector<double> errors;
    for (double d : method[0] == 'f' ? std::vector{20.0, 10.0} : std::vector{20.0, 10.0, 5.0}) {
      const Marched two(scene_of(half_span(bar("bottom", -40) + bar("top", 40)), settle), method, d);
      errors.push_back(error(-two.end("mid_y"), deflection(both)));
      const Marched lower(scene_of(half_span(bar("bottom", -40)), settle), method, d);
      const double e = error(-lower.end("mid_y"), deflection(one));
      fmt::print("{} d = {}: two bars {:+.2f} %, one bar {:+.2f} %\n", method, d, errors.back(), e);
      if (d <= 10) {
        EXPECT_NEAR(e, 0, 4) << method;
      }
      EXPECT_LT(two.balance(), 1e-3);
    }
    EXPECT_LT(std::abs(errors.back()), 2) << method;
    EXPECT_LT(std::abs(errors.back()), std::abs(errors.front())) << method;
  }
}

// A bar that yields at 100 MPa in a soft matrix, pulled slowly (up to the end of a ramp of 20 ms; first
// period 4 L / c = 0.6 ms): its stress stays at the yield stress, the matrix takes the rest, strain = (F -
// yield A_b) / (E A).
TEST(Bars, YieldAtTheirPlateau) {
  Beam b;
  b.young = "10 GPa";
  b.size = "size = [\"300 mm\", \"50 mm\"]\norigin = [\"0 mm\", \"-25 mm\"]\nthickness = \"100 mm\"";
  b.parts =
      "[[symmetry]]\nat = \"x-\"\n[[supports]]\npoint = [\"0 mm\", \"0 mm\"]\nfix = [\"y\"]\n[damping]\nrate "
      "= \"5000 1/s\"\n[[loads]]\nat = \"x+\"\n"
      "force = [\"60 kN\", \"0 N\"]\nhistory = {ramp = \"20 ms\"}\n"
      "[bars.middle]\nfrom = [\"0 mm\", \"0 mm\"]\nto = [\"300 mm\", \"0 mm\"]\narea = \"250 "
      "mm^2\"\nmaterial = \"rebar\"\n" +
      probe("matrix", "strain", "\"50 mm\", \"0 mm\"");
  b.rebar = "law = \"plastic\"\nyield = \"100 MPa\"\nhardening = \"0 Pa\"";
  const Scene scene = scene_of(b, "[time]\nduration = \"20 ms\"\nsamples = 100\n");
  const double strain = (60e3 - 100e6 * 250e-6) / (10e9 * 0.005);
  for (const char* method : {"fem-assumed-strain", "sph-corrected"}) {
    const Marched r(scene, method, 5);
    EXPECT_NEAR(error(r.end("matrix_xx"), strain), 0, 1.5) << method;
    double worst = 0;
    for (const BarPiece& p : r.bars())
      if (p.position[0] < 0.15) worst = std::max(worst, std::abs(p.stress / 100e6 - 1));
    EXPECT_LT(worst, 1e-3) << method;
    EXPECT_GT(r.march->ledger().plastic, 0) << method;
    EXPECT_LT(r.balance(), 1e-9) << method;
  }
}

// A reinforced half beam thrown against its support: large rotation and yielding bars, and the energy still
// balances.
TEST(Bars, EnergyBalancesInAnImpact) {
  Beam b = half_span(
      "[bars.bottom]\nfrom = [\"0 mm\", \"-38 mm\"]\nto = [\"950 mm\", \"-38 mm\"]\narea = \"300 "
      "mm^2\"\nmaterial = \"rebar\"\n"
      "[[initial]]\nbody = \"beam\"\nvelocity = [\"0 m/s\", \"-3 m/s\"]\n");
  b.rebar = "law = \"plastic\"\nyield = \"100 MPa\"\nhardening = \"2 GPa\"";
  Scene scene = scene_of(b, "[time]\nduration = \"20 ms\"\nsamples = 200\n");
  for (bool large : {false, true})
    for (const char* method : {"fem-assumed-strain", "sph-corrected", "sph-classic-share"}) {
      if (large && std::string(method) == "sph-classic-share") continue;
      scene.large_motion = large;
      const Marched r(scene, method, 12.5);
      EXPECT_GT(r.march->ledger().plastic, 0.01 * r.march->ledger().initial) << method;
      EXPECT_LT(r.balance(), large ? 1e-3 : 1e-9) << method;
    }
}

}  // namespace
}  // namespace femsph::test
