// Finds the points that are tied, and their facets.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "model/motion/bodies/motion.hpp"
#include "model/motion/bodies/overlap.hpp"
#include "model/motion/effects/ties.hpp"
#include "model/numerics/box_grid.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

namespace {

[[noreturn]] void refuse(const Scene& scene, const Contact& contact, const std::string& what) {
  throw MotionError(fmt::format("{}:{}:{}: contact \"{}\": {}", scene.file, contact.source.line,
                                contact.source.column, contact.name, what));
}

/// N_c = (1 - a)(1 - b), a (1 - b), a b, (1 - a) b: their derivatives by a and b.
void differentiate(const std::array<double, 4>& n, int dim, std::array<double, 4>& by_a,
                   std::array<double, 4>& by_b) {
  if (dim == 2) {
    by_a = {-1, 1, 0, 0};
    by_b = {};
    return;
  }
  const double a = n[1] + n[2], b = n[2] + n[3];
  by_a = {b - 1, 1 - b, b, -b};
  by_b = {a - 1, -a, a, 1 - a};
}

/// Whether the first of two bodies is the one whose points are tied: the one with the smaller facets, so that
/// every facet of the other has ties; for facets of equal size the one with the lower acoustic impedance.
bool gives_points(const Surface& mine, const Surface& other, double my_impedance, double other_impedance) {
  const double a = mine.facet_area(), b = other.facet_area();
  return std::abs(a - b) > 0.01 * std::max(a, b) ? a < b : my_impedance <= other_impedance;
}

/// A point of the other body that lies inside this one. A shape without a mesh has exact sides, and 5 % of a
/// spacing is tolerated. Of a mesh only the facets are known, and its curved sides lie between them: a
/// quarter of a spacing is tolerated.
std::optional<Overlap> overlap_of_tied(const Surface& body, const Shape& shape, const Surface& other,
                                       double spacing) {
  const Enclosure enclosure(body);
  const double tolerance = shape.cells() ? 0.25 * std::max(body.spacing, other.spacing) : 0.05 * spacing;
  for (const Point& p : other.now) {
    if (!shape.cells() && !shape.contains(p, -tolerance)) continue;
    if (const double depth = enclosure.depth(p, tolerance); depth > 0) return Overlap{p, depth};
  }
  return {};
}

}  // namespace

Ties::Ties(const Scene& scene, const std::vector<MovingBody>& bodies) : dim_(scene.dim()) {
  for (const Contact& contact : scene.contacts)
    if (contact.tied) tie(scene, contact, bodies);
  force_.assign(nodes_.size(), {});
}

void Ties::tie(const Scene& scene, const Contact& contact, const std::vector<MovingBody>& bodies) {
  std::array<std::size_t, 2> party{};
  std::vector<Surface> surfaces;
  std::array<double, 2> impedance{};
  std::array<const MovingBody*, 2> moving{};
  for (int s = 0; s < 2; ++s) {
    const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const MovingBody& body) {
      return body.index == contact.between[s];
    });
    party[s] = std::size_t(found - bodies.begin());
    moving[s] = &*found;
    const double density = scene.material_of(scene.bodies[found->index]).density;
    surfaces.emplace_back(*found, density, dim_ == 2 ? scene.bodies[found->index].thickness : 1.0);
    impedance[s] = density * found->discretization->wave_speed();
    if (surfaces[s].facets.empty())
      refuse(scene, contact, fmt::format("body \"{}\" has no boundary between its points", found->name));
  }
  const int mine = gives_points(surfaces[0], surfaces[1], impedance[0], impedance[1]) ? 0 : 1;
  const Surface &points = surfaces[mine], &facets = surfaces[1 - mine];
  const double spacing = 0.5 * (points.spacing + facets.spacing);
  const double reach = 1.1 * spacing;
  for (int s = 0; s < 2; ++s)
    if (const auto found = overlap_of_tied(
            surfaces[s], *scene.bodies[contact.between[s]].shape, surfaces[1 - s], spacing))
      refuse(scene, contact,
             fmt::format("the bodies overlap by {:.4g} mm at ({:.6g}, {:.6g}, {:.6g}) m, where there would "
                         "be mass twice; expected them to touch",
                         1e3 * found->depth, found->at[0], found->at[1], found->at[2]));
  std::vector<BoxGrid::Box> boxes;
  for (const Facet& f : facets.facets) {
    const std::array<Point, 4> x = facets.corners(f);
    BoxGrid::Box box{x[0], x[0]};
    for (int k = 0; k < 2 * (dim_ - 1); ++k)
      for (int c = 0; c < 3; ++c)
        box.lower[c] = std::min(box.lower[c], x[k][c] - reach),
        box.upper[c] = std::max(box.upper[c], x[k][c] + reach);
    boxes.push_back(box);
  }
  const BoxGrid grid(boxes);
  Bond bond{&contact, party[mine], party[1 - mine], ties_.size(), ties_.size(), {}};
  // Surface points lie on the surface; those of a lattice of particles lie up to half a spacing below a
  // curved one.
  for (const double gap : {0.05 * spacing, reach}) {
    for (std::size_t p = 0; p < points.now.size(); ++p) {
      const Point& x = points.now[p];
      Projection best;
      int piece = -1;
      grid.any_near(x, 0, [&](int f) {
        const Projection s = project_onto_facet(dim_, facets.corners(facets.facets[std::size_t(f)]), x);
        const bool faces = dot(points.area[p], s.normal) < -0.1 * norm(points.area[p]);
        if (faces && std::abs(s.gap) <= gap && s.beyond <= 0.05 * spacing &&
            (piece < 0 || std::hypot(s.gap, s.beyond) < std::hypot(best.gap, best.beyond)))
          best = s, piece = f;
        return false;
      });
      if (piece < 0) continue;
      Tie t{node(bodies, bond.from, points.point[p]),
            {},
            best.share,
            {},
            {},
            std::abs(best.gap) > 1e-6 * spacing ? best.gap : 0.0,
            best.normal,
            2 * (dim_ - 1)};
      for (int c = 0; c < t.corners; ++c)
        t.facet[c] = node(bodies, bond.onto, facets.point[facets.facets[std::size_t(piece)].points[c]]);
      differentiate(t.share, dim_, t.along, t.across);
      ties_.push_back(t);
      Point apart = points.displacement(*moving[mine], p);
      for (int c = 0; c < t.corners; ++c)
        apart = apart - t.share[c] * facets.displacement(
                                         *moving[1 - mine], facets.facets[std::size_t(piece)].points[c]);
      if (norm(apart) > 1e-3 * spacing)
        refuse(scene, contact,
               fmt::format("the displacements at the start part its two bodies by {:.4g} mm at ({:.6g}, "
                           "{:.6g}, {:.6g}) m; expected the same for both",
                           1e3 * norm(apart), x[0], x[1], x[2]));
    }
    bond.end = ties_.size();
    if (bond.end > bond.begin) break;
  }
  if (bond.end == bond.begin)
    refuse(scene, contact,
           fmt::format("the bodies touch nowhere at the start, so that there is nothing to tie; expected "
                       "surfaces within {:.4g} mm of each other",
                       1e3 * reach));
  for (const Node& n : nodes_)
    for (int c = 0; c < dim_; ++c) {
      const std::vector<std::size_t>& taken = bodies[n.body].constrained;
      if (std::find(taken.begin(), taken.end(), bodies[n.body].discretization->layout().at(n.point, c)) !=
          taken.end())
        refuse(
            scene, contact,
            fmt::format(
                "it shares a point of body \"{}\" with a support of mode = \"mean\"; keep their places apart",
                bodies[n.body].name));
    }
  bonds_.push_back(bond);
}

std::size_t Ties::node(const std::vector<MovingBody>& bodies, std::size_t body, std::size_t point) {
  const auto key = std::pair{body, point};
  const auto [found, fresh] = number_.try_emplace(key, nodes_.size());
  if (fresh) {
    const Discretization& d = *bodies[body].discretization;
    Node n{body, point, d.position(point), {}};
    for (int c = 0; c < dim_; ++c) n.inverse_mass[c] = bodies[body].inverse_mass[d.layout().at(point, c)];
    nodes_.push_back(n);
  }
  return found->second;
}

}  // namespace femsph
