// The velocities of bodies at t = 0.

#include <fmt/format.h>

#include "model/motion/effects/effect.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph {
namespace {

using namespace scene_reader;

KeyTable initial_keys() {
  return {"[[initial]]",
          "The velocity of a body at t = 0: v(X) = s(X) (velocity + spin x (X - centre) + gradient (X - "
          "centre)), with s = 1 or the wave of \"profile\". Several tables of one body add up.",
          {body_key(),
           {"velocity", key_holds::vector(dimension::velocity), "A uniform velocity. 0 unless given."},
           {"spin",
            key_holds::vector(dimension::rotation) + "; in a plane scene only " +
                key_holds::quantity(dimension::rotation) + ", about z",
            "An angular velocity. 0 unless given."},
           {"gradient", key_holds::matrix(&dimension::rate),
            "A velocity gradient: the rows dv_x/dX dv_x/dY .., dv_y/dX .. and so on. 0 unless given."},
           {"centre", key_holds::vector(dimension::length),
            "The point where \"spin\" and \"gradient\" give no velocity. The origin unless given."}}};
}

KeyTable profile_keys() {
  return {"[initial.profile]",
          "Makes an initial velocity a sine wave along an axis, written inline: profile = {axis = \"y\", "
          "wavelength = \"24 m\"} is s(X) = sin(2 pi (Y - origin) / wavelength).",
          {{"axis", key_holds::words(std::vector<std::string>{"x", "y", "z"}),
            "The axis along which the velocity varies.", true},
           {"wavelength", key_holds::quantity(dimension::length), "The length of one period.", true},
           {"origin", key_holds::quantity(dimension::length),
            "A coordinate at which the sine is zero and rises. 0 unless given."}}};
}

/// In a plane a body can only turn about z, so one number says it all.
std::optional<Point> read_spin(Fields& fields, int dim) {
  if (dim == 0 && fields.has("spin"))
    return fields.accept("spin"), std::nullopt;  // a rate or a vector: the plane of the scene is at fault
  if (dim != 2) return fields.vector("spin", Need::optional, dimension::rotation, dim);
  const auto rate = fields.quantity("spin", Need::optional, dimension::rotation);
  return rate ? std::optional(Point{0, 0, *rate}) : std::nullopt;
}

std::optional<InitialVelocity::Wave> read_profile(Fields& start, int dim) {
  auto fields = start.table(
      "profile", Need::optional, "a table such as {axis = \"y\", wavelength = \"24 m\"}");
  if (!fields) return {};
  std::vector<std::pair<std::string, int>> axes = {{"x", 0}, {"y", 1}, {"z", 2}};
  if (dim == 2) axes.pop_back();
  const auto axis = fields->choice<int>("axis", Need::required, axes);
  const auto wavelength = fields->quantity("wavelength", Need::required, dimension::length, Sign::positive);
  const auto origin = fields->quantity("origin", Need::optional, dimension::length);
  fields->done();
  return axis && wavelength ? std::optional(InitialVelocity::Wave{*axis, *wavelength, origin.value_or(0)})
                            : std::nullopt;
}

void read_initial_velocities(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("initial")) {
    const auto body = read_body_of(fields, reading);
    const auto velocity = fields.vector("velocity", Need::optional, dimension::velocity, reading.dim);
    const auto spin = read_spin(fields, reading.dim);
    const auto gradient = fields.matrix("gradient", Need::optional, &dimension::rate, reading.dim);
    const auto centre = fields.vector("centre", Need::optional, dimension::length, reading.dim);
    const auto profile = read_profile(fields, reading.dim);
    fields.done();
    const bool misspelt = fields.misspelt({"velocity", "spin", "gradient"});
    if (!misspelt && !fields.has("velocity") && !fields.has("spin") && !fields.has("gradient"))
      fields.fault("body", "no motion in [[initial]]; expected \"velocity\", \"spin\" or \"gradient\"");
    if (!misspelt && fields.has("centre") && !fields.has("spin") && !fields.has("gradient"))
      fields.fault("centre", "\"centre\" without \"spin\" or \"gradient\"; expected one of them with it");
    if (!body) continue;
    if (reading.scene.bodies[*body].rigid)
      for (const char* key : {"gradient", "profile"})
        if (fields.has(key))
          fields.fault(
              key, fmt::format("\"{}\" of body {}, which is rigid; expected \"velocity\" and \"spin\" only",
                               key, in_quotes(reading.scene.bodies[*body].name)));
    reading.scene.initial_velocities.push_back(
        {*body, velocity.value_or(Point{}), spin.value_or(Point{}), gradient.value_or(Matrix{}),
         centre.value_or(Point{}), profile});
  }
}

class InitialVelocities : public Effect {
 public:
  explicit InitialVelocities(Motion&) {}
  void start(Motion& motion) override {
    for (const InitialVelocity& start : motion.scene.initial_velocities) {
      for (MovingBody& body : motion.bodies)
        if (start.body == body.index) add(start, body);
      for (RigidBody& body : motion.rigid)
        if (start.body == body.index) {
          const Point v = start.at(body.centre());
          for (int c = 0; c < 3; ++c)
            body.velocity[c] += v[c], body.spin[c] += body.inertia[c] * start.spin[c];
        }
    }
  }

 private:
  static void add(const InitialVelocity& start, MovingBody& body) {
    const Layout& at = body.discretization->layout();
    for (std::size_t i = 0; i < at.points; ++i) {
      const Point v = start.at(body.discretization->position(i));
      for (int c = 0; c < at.dim; ++c)
        if (const std::size_t slot = at.at(i, c); body.inverse_mass[slot] != 0) body.v[slot] += v[c];
    }
  }
};

}  // namespace

EffectEntry initial_velocity_effect() {
  EffectEntry e{{"initial velocity", "the velocity of a body at t = 0"}};
  e.asked_by = "[[initial]]";
  e.on = [](const Scene& s) { return !s.initial_velocities.empty(); };
  e.tables = {initial_keys(), profile_keys()};
  e.read = read_initial_velocities;
  e.make = make_effect<InitialVelocities>;
  return e;
}

}  // namespace femsph
