#include "tests/bench/cases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "model/scene/shapes/box.hpp"

namespace femsph::bench {

namespace {

compare::Method fem(const char* name) { return compare::method_named(name); }
compare::Method sph(const char* name, double smoothing, auto&&... change) {
  compare::Method m = compare::method_named(name);
  auto& options = std::get<sph::Options>(m.options);
  options.smoothing = smoothing;
  (change(options), ...);
  return m;
}
void viscous(sph::Options& o) { o.viscosity = {5, 5, 1}; }
void irregular(sph::Options& o) { o.jitter = 0.2; }

Place side(const char* name) {
  Place place;
  place.sides = {name};
  return place;
}

}  // namespace

Scene scene_of(const Case& c, double& spacing, double pull) {
  Scene s;
  s.plane = c.dim == 3 ? Plane::none : c.plane;
  s.large_motion = c.large_motion;
  s.materials["steel"] = Material{"steel", 2.1e11, 0.3, 7850};
  if (c.yield != Yield::elastic)
    s.materials.at("steel").parameters = Plasticity{c.yield == Yield::idle ? 300e9 : 300e6, 2.1e9};
  s.bodies.push_back({"beam", std::make_shared<Box>(c.dim, Point{}, Point{1, 0.1, c.dim == 3 ? 0.1 : 0.0}),
                      c.dim == 2 ? 0.1 : 1.0, "steel"});
  spacing = 0.1 / std::round(c.dim == 2 ? std::sqrt(c.units / 10) : std::cbrt(c.units / 10));
  s.supports.push_back({side("x-"), {true, true, true}});
  if (pull > 0) {
    InitialVelocity v;
    v.gradient[0][0] = pull;
    Support end{side("x+"), {true, false, false}};
    end.velocity = {pull, 0, 0};
    s.initial_velocities.push_back(v);
    s.supports.push_back(end);
  } else {
    Load load;
    load.place = side("x+");
    load.force = {0, -1e4, 0};
    s.loads.push_back(load);
  }
  s.samples = s.snapshots = 0;
  if (c.change) c.change(s);
  return s;
}

std::vector<Case> targets() {
  const auto strain = Plane::strain, stress = Plane::stress;
  std::vector<Case> all;
  const auto add = [&](std::string name, int dim, compare::Method m, double target) {
    all.push_back({std::move(name), dim, std::move(m), target});
  };
  const auto plastic =
      [&](const std::string& name, int dim, const compare::Method& m, double target, bool large = true) {
        for (const Yield yield : {Yield::all, Yield::tenth})
          for (const Plane plane : {strain, stress}) {
            if (dim == 3 && plane == stress) continue;
            const char* in = dim == 3 ? "" : plane == strain ? ", plane strain" : ", plane stress";
            all.push_back({name + in + (yield == Yield::all ? ", all yield" : ", a tenth yields"), dim, m,
                           target, yield, large, plane});
          }
      };
  add("2D full elastic", 2, fem("fem-full"), 25);
  plastic("2D full J2 finite rotation", 2, fem("fem-full"), 40);
  plastic("2D one-point J2 + stabilization", 2, fem("fem-one-point"), 20);
  add("3D full elastic", 3, fem("fem-full"), 90);
  plastic("3D full J2 finite rotation", 3, fem("fem-full"), 140);
  plastic("3D one-point J2 + stabilization", 3, fem("fem-one-point"), 55);
  plastic("2D corrected SPH, 8 neighbours", 2, sph("sph-corrected", 1), 15, false);
  plastic("2D corrected SPH, 20 neighbours", 2, sph("sph-corrected", 1.2), 25, false);
  plastic("3D corrected SPH, 26 neighbours", 3, sph("sph-corrected", 1), 40, false);
  plastic("3D corrected SPH, 56 neighbours", 3, sph("sph-corrected", 1.2), 90, false);
  plastic("3D corrected SPH, 80 neighbours", 3, sph("sph-corrected", 1.3), 115, false);
  add("2D corrected SPH, irregular, 20 neighbours, elastic", 2, sph("sph-corrected", 1.2, irregular), 75);
  add("3D corrected SPH, irregular, 56 neighbours, elastic", 3, sph("sph-corrected", 1.2, irregular), 300);
  plastic("2D corrected SPH, irregular, 20 neighbours", 2, sph("sph-corrected", 1.2, irregular), 75, false);
  plastic("3D corrected SPH, irregular, 56 neighbours", 3, sph("sph-corrected", 1.2, irregular), 300, false);
  add("2D classic SPH with viscosity, fixed, 8 neighbours", 2, sph("sph-classic-share", 1, viscous), 40);
  add("2D classic SPH with viscosity, fixed, 20 neighbours", 2, sph("sph-classic-share", 1.2, viscous), 80);
  Case moving{
      "2D classic SPH, updated, 20 neighbours, search included", 2, sph("sph-classic-share", 1.2), 250};
  moving.large_motion = moving.moving = true;
  all.push_back(moving);
  moving.name = "2D classic SPH with viscosity, updated, 20 neighbours, search included";
  moving.method = sph("sph-classic-share", 1.2, viscous);
  all.push_back(moving);
  moving.name += ", J2";
  moving.yield = Yield::all;
  all.push_back(moving);
  for (const int dim : {2, 3}) {  // bonds with memory: elastic bodies keep their lists
    Case bonds{dim == 2 ? "2D updated SPH, 20 neighbours" : "3D updated SPH, 56 neighbours", dim,
               sph("sph-updated", 1.2), dim == 2 ? 150.0 : 600.0};
    bonds.large_motion = bonds.moving = true;
    all.push_back(bonds);
    bonds.name += ", search included, J2";
    bonds.yield = Yield::all;
    all.push_back(bonds);
  }
  return all;
}

std::vector<Case> methods() {
  std::vector<Case> all;
  for (const int dim : {2, 3})
    for (const compare::Method& m : compare::methods())
      all.push_back({fmt::format("{}D {}", dim, m.name), dim, m});
  return all;
}

std::vector<Case> effects() {
  std::vector<Case> all;
  for (const int dim : {2, 3})
    for (const char* name : {"fem-full", "fem-one-point", "sph-corrected"}) {
      const std::string plain = fmt::format("{}D {}", dim, name);
      const Case base{plain, dim, compare::method_named(name)};
      all.push_back(base);
      const auto add = [&](const std::string& effect, auto&& change) {
        Case c = base;
        c.name = plain + ", " + effect;
        c.without = plain;
        change(c);
        all.push_back(c);
      };
      const auto scene = [&](const std::string& effect, std::function<void(Scene&)> change) {
        add(effect, [&](Case& c) { c.change = change; });
      };
      add("large motion", [](Case& c) { c.large_motion = true; });
      add("plasticity that never yields", [](Case& c) { c.yield = Yield::idle; });
      add("plasticity, all yield", [](Case& c) { c.yield = Yield::all; });
      if (!std::strcmp(name, "sph-corrected")) {
        add("no hourglass control", [](Case& c) { std::get<sph::Options>(c.method.options).hourglass = 0; });
        add("neighbour lists instead of shared stencils",
            [](Case& c) { std::get<sph::Options>(c.method.options).force_lists = true; });
      }
      if (!std::strcmp(name, "fem-one-point"))
        add("Flanagan and Belytschko's control instead",
            [](Case& c) { std::get<fem::Options>(c.method.options).hourglass = 0.05; });
      if (!std::strcmp(name, "fem-one-point")) continue;
      scene("damping", [](Scene& s) { s.damping = 100; });
      scene("gravity", [](Scene& s) { s.gravity = Point{0, -9.81, 0}; });
      scene("a symmetry plane", [=](Scene& s) { s.symmetries.push_back({side("y-")}); });
      scene("a bar", [](Scene& s) {
        s.bars.push_back({"bar",
                          0,
                          {0, 0.05, s.dim() == 3 ? 0.05 : 0},
                          {1, 0.05, s.dim() == 3 ? 0.05 : 0},
                          1e-4,
                          "steel"});
      });
      scene("a support on its mean", [](Scene& s) { s.supports[0].mean = true; });
      scene("contact with a rigid block", [](Scene& s) {
        Body block{
            "block",
            std::make_shared<Box>(s.dim(), Point{0.4, 0.1, 0}, Point{0.2, 0.1, s.dim() == 3 ? 0.1 : 0.0}),
            s.dim() == 2 ? 0.1 : 1.0, ""};
        block.rigid = true;
        block.mass = 10;
        s.bodies.push_back(block);
        s.contacts.push_back({"touch", {0, 1}, 1, 0, {}, false});
        InitialVelocity v;
        v.body = 1;
        v.velocity = {0, -1, 0};
        s.initial_velocities.push_back(v);
      });
    }
  for (const double smoothing : {1.0, 1.2}) {
    const std::string plain = fmt::format("2D sph-classic-share, h = {:g} d", smoothing);
    all.push_back({plain, 2, sph("sph-classic-share", smoothing)});
    Case c{plain + ", viscosity", 2, sph("sph-classic-share", smoothing, viscous)};
    c.without = plain;
    all.push_back(c);
  }
  return all;
}

}  // namespace femsph::bench
