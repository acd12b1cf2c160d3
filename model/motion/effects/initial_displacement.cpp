// The displacements of bodies at t = 0.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/motion/effects/effect.hpp"
#include "model/scene/place_extent.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph {
namespace {

using namespace scene_reader;

KeyTable initial_displacement_keys() {
  return {"[[initial_displacements]]",
          "The displacement of a body at t = 0: u = gradient (X - centre). At most one table for each body.",
          {body_key(),
           {"gradient", key_holds::matrix(nullptr),
            "The displacement gradient: the rows du_x/dX du_x/dY .., du_y/dX .. and so on.", true},
           {"centre", key_holds::vector(dimension::length),
            "The point that is not displaced. The origin unless given."}}};
}

void read_initial_displacements(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("initial_displacements")) {
    const auto body = read_body_of(fields, reading);
    const auto gradient = fields.matrix("gradient", Need::required, nullptr, reading.dim);
    const auto centre = fields.vector("centre", Need::optional, dimension::length, reading.dim);
    fields.done();
    if (body) require_deformable(fields, "initial displacement", *body, reading);
    if (!body || !gradient || reading.scene.bodies[*body].rigid) continue;
    const InitialDisplacement start{*body, *gradient, centre.value_or(Point{})};
    double det = 0;  // of 1 + gradient
    Matrix F = *gradient;
    for (int a = 0; a < 3; ++a) F[a][a] += 1;
    for (int a = 0; a < 3; ++a)
      det += F[0][a] * (F[1][(a + 1) % 3] * F[2][(a + 2) % 3] - F[1][(a + 2) % 3] * F[2][(a + 1) % 3]);
    if (!(det > 0))
      fields.fault("gradient", "\"gradient\" turns the body inside out; expected det(1 + gradient) > 0");
    // A plane of symmetry stays where it is: u = gradient (X - centre) must vanish along its normal all over
    // it.
    for (const Symmetry& plane : reading.scene.symmetries) {
      const Shape* shape = reading.scene.bodies[*body].shape.get();
      if (plane.place.body != *body || !shape) continue;
      const int n = plane.axis();
      Point on = start.centre;
      on[n] = plane.position(*shape);
      bool still = std::abs(start.at(on)[n]) <= point_tolerance(*shape);
      for (int a = 0; a < 3; ++a) still = still && (a == n || (*gradient)[n][a] == 0);
      if (!still)
        fields.fault("gradient", fmt::format("the initial displacement leaves the symmetry plane {}; "
                                             "expected none along its normal there (see \"centre\")",
                                             in_quotes(plane.place.sides[0])));
    }
    const auto& known = reading.scene.initial_displacements;
    if (std::any_of(known.begin(), known.end(),
                    [&](const InitialDisplacement& other) { return other.body == *body; }))
      fields.fault("body", fmt::format("body {} has an initial displacement already; expected one a body",
                                       in_quotes(reading.scene.bodies[*body].name)));
    reading.scene.initial_displacements.push_back(start);
  }
}

class InitialDisplacements : public Effect {
 public:
  explicit InitialDisplacements(Motion& motion) {
    for (MovingBody& body : motion.bodies) {
      const Layout& at = body.discretization->layout();
      for (const InitialDisplacement& start : motion.scene.initial_displacements)
        if (start.body == body.index)
          for (std::size_t i = 0; i < at.points; ++i) {
            const Point u = start.at(body.discretization->position(i));
            for (int c = 0; c < at.dim; ++c) body.u[at.at(i, c)] = u[c];
          }
    }
  }
  bool strains_the_start() const override { return true; }
};

}  // namespace

EffectEntry initial_displacement_effect() {
  EffectEntry e{{"initial displacement", "the displacement of a body at t = 0"}};
  e.asked_by = "[[initial_displacements]]";
  e.on = [](const Scene& s) { return !s.initial_displacements.empty(); };
  e.tables = {initial_displacement_keys()};
  e.read = read_initial_displacements;
  e.make = make_effect<InitialDisplacements>;
  return e;
}

}  // namespace femsph
