#include "model/scene/singular.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/scene/place_extent.hpp"

namespace femsph {
namespace {

bool moves(const Quantity& quantity) { return !quantity.on_material; }

/// Names of the probes and sections of a body that have a point for which reads(quantity, point) is true.
template <class Reads>
std::vector<std::string> observers(const Scene& scene, std::size_t body, Reads reads) {
  std::vector<std::string> names;
  for (const Probe& probe : scene.probes)
    if (probe.body == body && reads(*probe.quantity, probe.point)) names.push_back(probe.name);
  for (const Section& section : scene.sections) {
    if (section.body != body) continue;
    const int steps = std::clamp(section.count - 1, 1, 1000);
    for (int i = 0; i <= steps; ++i) {
      Point p;
      for (int c = 0; c < 3; ++c) p[c] = section.from[c] + (section.to[c] - section.from[c]) * i / steps;
      if (!reads(*section.quantity, p)) continue;
      names.push_back(section.name);
      break;
    }
  }
  return names;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + in_quotes(names[i]);
  return text + (names.size() == 1 ? " reads" : " read");
}

const char* word_of(const Scene& scene, int codimension) {
  return codimension >= scene.dim() ? "a point" : "a line";
}

double largest_factor(const TimeHistory& history) {
  double most = 0;
  for (const double f : history.factor) most = std::max(most, std::abs(f));
  return most;
}

/// Whether no force acts on a body along an axis, so that the only support along it has no reaction.
bool free_of_force(const Scene& scene, std::size_t body, int axis) {
  double sum = 0, most = 0;
  for (const Load& load : scene.loads) {
    if (load.place.body != body) continue;
    if (load.pressure != 0) return false;
    sum += load.force[axis] * load.history.factor.back(),
        most = std::max(most, std::abs(load.force[axis]) * largest_factor(load.history));
  }
  const auto of_body = [&](const auto& list) {
    return std::any_of(list.begin(), list.end(), [&](const auto& one) { return one.body == body; });
  };
  const bool touches = std::any_of(scene.contacts.begin(), scene.contacts.end(), [&](const Contact& c) {
    return c.between[0] == body || c.between[1] == body;
  });
  const bool moved = std::any_of(scene.supports.begin(), scene.supports.end(), [&](const Support& s) {
    return s.place.body == body && s.velocity != Point{};
  });
  return std::abs(sum) <= 1e-12 * most && !(scene.gravity && (*scene.gravity)[axis] != 0) &&
         !of_body(scene.initial_velocities) && !of_body(scene.initial_displacements) && !touches && !moved;
}

bool may_bear(const Scene& scene, const Support& support) {
  for (int c = 0; c < scene.dim(); ++c) {
    if (!support.fixed[c]) continue;
    int holders = 0;
    for (const Support& other : scene.holds())
      holders += other.place.body == support.place.body && other.fixed[c];
    if (holders > 1 || !free_of_force(scene, support.place.body, c)) return true;
  }
  return false;
}

void add_forces(const Scene& scene, double reach, std::vector<SingularPlace>& found) {
  for (const Load& load : scene.loads) {
    const std::size_t b = load.place.body;
    const int lacking = scene.bodies[b].rigid || load.force == Point{} || largest_factor(load.history) == 0
                            ? 0
                            : codimension(scene, load.place);
    if (lacking < 2) continue;
    const auto names = observers(
        scene, b, [&](const Quantity&, const Point& p) { return at_place(scene, load.place, p, reach); });
    if (names.empty()) continue;
    std::string text = fmt::format(
        "a force on {}: the exact displacement and stress there are infinite, so that no spacing is fine "
        "enough for what {} there",
        word_of(scene, lacking), listed(names));
    const double each = sinks_per_halving(scene, load.place) *
                        std::max(
                            {std::abs(load.force[0]), std::abs(load.force[1]), std::abs(load.force[2])}) *
                        largest_factor(load.history);
    if (each > 0)
      text += fmt::format(
          " (the displacement gains about {:.3g} mm with every halving of the spacing)", 1e3 * each);
    found.push_back({SingularPlace::Kind::force, b, load.place.source, names,
                     text + "; what is read away from it converges; expected a force on part of a side (at "
                            "with \"within\"), or a reading elsewhere"});
  }
}

void add_holds(const Scene& scene, double reach, std::vector<SingularPlace>& found) {
  for (const Support& support : scene.supports) {
    const std::size_t b = support.place.body;
    const int lacking = scene.bodies[b].rigid || support.mean ? 0 : codimension(scene, support.place);
    if (lacking < 2 || !may_bear(scene, support)) continue;
    const auto names = observers(scene, b, [&](const Quantity& quantity, const Point& p) {
      return moves(quantity) != at_place(scene, support.place, p, reach);
    });
    if (names.empty()) continue;
    found.push_back(
        {SingularPlace::Kind::hold, b, support.place.source, names,
         fmt::format(
             "a support on {}: if it bears a reaction, the body sinks into it without limit as the spacing "
             "is refined, and with it what {}; stress away from it converges, and so do "
             "displacements against each other; expected a support on part of a side (at with \"within\")",
             word_of(scene, lacking), listed(names))});
  }
}

/// Whether no support fixes this side of a box along its normal.
bool is_free(const Scene& scene, std::size_t body, int axis, bool upper) {
  const std::string side{"xyz"[axis], upper ? '+' : '-'};
  const auto holds = scene.holds();
  return std::none_of(holds.begin(), holds.end(), [&](const Support& s) {
    return s.place.body == body && s.fixed[axis] && !s.mean &&
           (s.place.sides.empty() ? !s.place.point : s.place.sides == std::vector<std::string>{side});
  });
}

/// The ends of a fixed side of a box: the ends of a patch that covers a part of it, and, with `clamps`, the
/// corners where a clamped side meets a free one.
std::vector<Region> ends_of(const Scene& scene, const Support& support, const Shape& box, bool clamps) {
  std::vector<Region> ends;
  const Region part = part_of(box, support.place);
  const int normal = support.place.sides[0][0] - 'x';
  for (int axis = 0; axis < scene.dim(); ++axis) {
    if (axis == normal) continue;
    for (const bool upper : {false, true}) {
      const double at = (upper ? part.upper : part.lower)[axis],
                   border = (upper ? box.upper() : box.lower())[axis];
      const bool inside = std::abs(at - border) > point_tolerance(box);
      if (!inside && !(clamps && support.fixed[normal] && support.fixed[axis] &&
                       is_free(scene, support.place.body, axis, upper)))
        continue;
      ends.push_back(part);
      ends.back().lower[axis] = ends.back().upper[axis] = at;
    }
  }
  return ends;
}

void add_clamps(const Scene& scene, double reach, std::vector<SingularPlace>& found) {
  for (const Support& support : scene.supports) {
    const std::size_t b = support.place.body;
    const Shape& box = *scene.bodies[b].shape;
    if (!box.is_box() || scene.bodies[b].rigid || support.mean || codimension(scene, support.place) != 1 ||
        support.place.sides.size() != 1)
      continue;
    const Material& m = scene.material_of(scene.bodies[b]);
    if (m.is_fluid()) continue;
    const bool bounded = m.plasticity() && m.plasticity()->perfect();
    const double near = std::max(reach, point_tolerance(box));
    const auto ends = ends_of(scene, support, box, m.poisson > 0);
    const auto names = observers(scene, b, [&](const Quantity& quantity, const Point& p) {
      const bool limited = bounded && quantity.of_stress;
      return !moves(quantity) && !limited &&
             std::any_of(ends.begin(), ends.end(), [&](const Region& end) { return end.contains(p, near); });
    });
    if (names.empty()) continue;
    const double lambda = clamped_corner_exponent(m.poisson, scene.plane);
    found.push_back(
        {SingularPlace::Kind::clamp, b, support.place.source, names,
         fmt::format(
             "where this held side ends, the exact elastic stress and strain are infinite{}, and {} there: "
             "no spacing is fine enough for that; expected a reading about one thickness away from it",
             support.place.within ? "" : fmt::format(" (as distance^{:.2f})", lambda - 1), listed(names))});
  }
}

/// Vertices of a plane mesh at which the body takes an angle of more than 240 degrees, and not the full
/// circle.
std::vector<Point> notches_of(const CellMesh& mesh) {
  constexpr int next[4] = {1, 3, 0, 2}, before[4] = {2, 0, 3, 1};
  std::vector<double> angle(mesh.vertices.size());
  for (const auto& cell : mesh.cells)
    for (int c = 0; c < 4; ++c) {
      const Point &v = mesh.vertices[cell[c]], &a = mesh.vertices[cell[next[c]]],
                  &b = mesh.vertices[cell[before[c]]];
      const double ax = a[0] - v[0], ay = a[1] - v[1], bx = b[0] - v[0], by = b[1] - v[1];
      angle[cell[c]] += std::atan2(std::abs(ax * by - ay * bx), ax * bx + ay * by) * 180 / std::numbers::pi;
    }
  std::vector<Point> found;
  for (std::size_t v = 0; v < angle.size(); ++v)
    if (angle[v] > 240 && angle[v] < 359) found.push_back(mesh.vertices[v]);
  return found;
}

/// In plane meshes. A round hole that is approximated by a polygon of seven sides or more has angles of less
/// than 240 degrees.
void add_notches(const Scene& scene, double reach, std::vector<SingularPlace>& found) {
  if (scene.dim() != 2) return;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const CellMesh* mesh = scene.bodies[b].shape->cells();
    if (!mesh || scene.bodies[b].rigid) continue;
    const double near = std::max(reach, point_tolerance(*scene.bodies[b].shape));
    const auto notches = notches_of(*mesh);
    const auto names = observers(scene, b, [&](const Quantity& quantity, const Point& p) {
      return !moves(quantity) && std::any_of(notches.begin(), notches.end(), [&](const Point& v) {
        return std::hypot(v[0] - p[0], v[1] - p[1]) <= near;
      });
    });
    if (!names.empty())
      found.push_back(
          {SingularPlace::Kind::notch,
           b,
           {},
           names,
           fmt::format("a re-entrant corner of body {}: the exact elastic stress and strain in "
                       "it are infinite, and {} there: no spacing is fine enough for that; "
                       "expected a round corner, or a reading away from it",
                       in_quotes(scene.bodies[b].name), listed(names))});
  }
}

}  // namespace

std::vector<SingularPlace> singular_places(const Scene& scene, double reach) {
  std::vector<SingularPlace> found;
  add_forces(scene, reach, found);
  add_holds(scene, reach, found);
  add_clamps(scene, reach, found);
  add_notches(scene, reach, found);
  return found;
}

std::vector<std::string> singular_warnings(const Scene& scene) {
  std::vector<std::string> lines;
  for (const SingularPlace& place : singular_places(scene))
    lines.push_back(
        place.source.line > 0
            ? fmt::format("{}:{}:{}: {}", scene.file, place.source.line, place.source.column, place.text)
            : place.text);
  return lines;
}

}  // namespace femsph
