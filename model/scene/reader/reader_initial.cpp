// How the bodies of a scene start: velocities and displacements.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/scene/reader/scene_reader.hpp"

namespace femsph::scene_reader {
namespace {

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

}  // namespace

void read_initial_velocities(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("initial")) {
    const auto body = read_body_of(fields, reading);
    const auto velocity = fields.vector("velocity", Need::optional, dimension::velocity, reading.dim);
    const auto spin = read_spin(fields, reading.dim);
    const auto gradient = fields.matrix("gradient", Need::optional, &dimension::rate, reading.dim);
    const auto centre = fields.vector("centre", Need::optional, dimension::length, reading.dim);
    const auto profile = read_profile(fields, reading.dim);
    fields.done();
    if (!fields.has("velocity") && !fields.has("spin") && !fields.has("gradient"))
      fields.fault("body", "no motion in [[initial]]; expected \"velocity\", \"spin\" or \"gradient\"");
    if (fields.has("centre") && !fields.has("spin") && !fields.has("gradient"))
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
      on[n] = (plane.upper() ? shape->upper() : shape->lower())[n];
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

}  // namespace femsph::scene_reader
