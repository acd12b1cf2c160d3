#pragma once
// The boundary of a deformable body, as contact sees it: points that move, facets between them, and the area
// each point stands for.

#include <vector>

#include "model/motion/bodies/discretization.hpp"
#include "model/motion/bodies/rigid.hpp"
#include "model/numerics/array.hpp"

namespace femsph {

struct MovingBody;

/// Where p stands to a facet. 2D: the foot divides the segment; 3D: Gauss-Newton for the nearest point of the
/// bilinear patch.
Stand stand_over(int dim, const std::array<Point, 4>& corners, const Point& p);

struct Surface {
  /// Points and facets of the body's boundary, renumbered; `thickness` out of the plane (1 in 3D).
  Surface(const MovingBody& body, double density, double thickness);

  int dim;
  double spacing, thickness;
  std::vector<std::size_t> point;     ///< the body's number of each
  std::vector<Facet> facets;          ///< of surface points
  std::vector<Point> reference, now;  ///< m; `now` of `active` points is kept up to date
  std::vector<Point> force;           ///< N, of this contact on each point
  std::vector<Point> area;            ///< outward vector area that each point stands for, m^2
  std::vector<double> area_limit;  ///< m / (rho d/2), m^2: no point counts more than a face of its mass would
  std::vector<std::size_t> active;  ///< those that the last search left to compute with

  std::array<Point, 4> corners(const Facet& f) const {
    return {now[f.points[0]], now[f.points[1]], now[f.points[2]], now[f.points[3]]};
  }
  double facet_area() const;  ///< mean, m^2
  void move_all(const MovingBody& body);
  void move_active(const MovingBody& body);
  /// Vector areas where the points are now.
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
