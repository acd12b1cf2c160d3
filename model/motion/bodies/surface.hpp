#pragma once
// The boundary of a deformable body for contact: its points, the facets between them, and the area of each
// point.

#include <vector>

#include "model/motion/bodies/discretization.hpp"
#include "model/motion/bodies/rigid.hpp"
#include "model/numerics/array.hpp"

namespace femsph {

struct MovingBody;

/// Projects p onto a facet. In 3D the closest point of the bilinear patch is found by Gauss-Newton iteration.
Projection project_onto_facet(int dim, const std::array<Point, 4>& corners, const Point& p);

struct Surface {
  /// The boundary of the body; facets refer to surface points, which are numbered from 0. `density` in
  /// kg/m^3; `thickness` normal to the plane in m, 1 in 3D.
  Surface(const MovingBody& body, double density, double thickness);

  int dim;
  double spacing, thickness;
  std::vector<std::size_t> point;  ///< the point of the body behind each surface point
  std::vector<Facet> facets;       ///< between surface points
  std::vector<Point> reference,
      now;                   ///< undeformed and present positions, m; `now` is current for `active` points
  std::vector<Point> force;  ///< contact force on each surface point, N
  std::vector<Point> area;   ///< outward area vector of each surface point, m^2
  std::vector<double>
      area_limit;  ///< m / (rho d/2), m^2: upper limit of the area of each surface point, from its mass
  std::vector<std::size_t>
      active;  ///< surface points that are near the other body, or belong to a facet that is

  std::array<Point, 4> corners(const Facet& f) const {
    return {now[f.points[0]], now[f.points[1]], now[f.points[2]], now[f.points[3]]};
  }
  double facet_area() const;  ///< mean, m^2
  void move_all(const MovingBody& body);
  void move_active(const MovingBody& body);
  /// Computes the area vectors at the present positions.
  void measure();
  double fastest(const MovingBody& body) const;  ///< m/s
  Point velocity(const MovingBody& body, std::size_t p) const;
  Point displacement(const MovingBody& body, std::size_t p) const;
  void add_forces_to(MovingBody& body) const;

 private:
  Point vector_area(const Facet& f) const;
  void move(const MovingBody& body, std::size_t p);
};

}  // namespace femsph
