#pragma once
// Bodies that are bonded where they touch at the start: contacts with kind = "tied".
//
// Each surface point of one body, the finer one, is tied to a material point of a facet of the other:
//   g = x - sum_c N_c x_c - g0 n = 0,
// with N_c the shape functions of the facet there, n its normal, and g0 the initial distance (0 where points
// coincide). A penalty that is stiff enough would shorten the time step. Instead the forces for which g = 0
// at the end of the step are solved for, as Lagrange multipliers l of the central difference method
// (Carpenter, Taylor & Katona, Int. J. Numer. Meth. Engng 32 (1991) 103):
//   S l = -(g / dt + keep G v) / push - G M^-1 f,   S = G M^-1 G^T,   G = dg/dx,
// with keep and push as in Leap. The forces are G^T l. A rigid-body motion of both bodies leaves g unchanged,
// so the forces G^T l have no resultant and no moment, to round-off. Constraints only lower the frequencies
// of a system, so the critical step is that of the bodies alone. S is diagonal where points coincide with
// points, and nearly so elsewhere: the conjugate gradient method with its diagonal as preconditioner needs
// few iterations.

#include <map>
#include <string>
#include <vector>

#include "model/motion/bodies/surface.hpp"
#include "model/numerics/archive.hpp"

namespace femsph {

class Ties {
 public:
  Ties() = default;
  /// Ties for all tied contacts of the scene. Throws MotionError if two bodies touch nowhere, if they
  /// overlap, or where a support of mode "mean" acts on the same points.
  Ties(const Scene& scene, const std::vector<MovingBody>& bodies);

  bool empty() const { return bonds_.empty(); }
  /// Adds the forces with which g = 0 at the end of the step dt (s); call it when all other forces are known.
  /// `before` (s) is the step that led here. `first`: t = 0, where the velocities are not known yet.
  void add_forces(std::vector<MovingBody>& bodies, double keep, double push, double dt, double before,
                  bool first);
  /// Applies impulses to the initial velocities that make G v = 0.
  void match_velocities(std::vector<MovingBody>& bodies) const;

  /// One contact.
  struct Bond {
    const Contact* contact;
    std::size_t from,
        onto;  ///< the body with the points, that with the facets: indices among the deformable bodies
    std::size_t begin, end;  ///< its range of ties
    Point force{};           ///< N, of the first body of the contact on the second, at the present step
  };
  const std::vector<Bond>& bonds() const { return bonds_; }
  double taken() const { return taken_; }  ///< minus the work of the forces so far, J; round-off where g0 = 0
  void state(Archive& archive) { archive("force", force_), archive("taken", taken_); }

 private:
  /// A point of a body that is tied, or that belongs to a facet with ties.
  struct Node {
    std::size_t body, point;
    Point reference, inverse_mass;  ///< m, undeformed; 1/kg, 0 where held
  };
  struct Tie {
    std::size_t node;
    std::array<std::size_t, 4> facet;
    std::array<double, 4> share, along,
        across;     ///< N_c and its derivatives by the two coordinates of the facet
    double offset;  ///< g0, m
    Point normal;   ///< n at the start
    int corners;
  };
  /// The tangents and the normal of a facet in its present position.
  struct Frame {
    Point along{}, across{}, normal{};
    double size = 0;  ///< |along x across|
  };

  void tie(const Scene& scene, const Contact& contact, const std::vector<MovingBody>& bodies);
  std::size_t node(const std::vector<MovingBody>& bodies, std::size_t body, std::size_t point);
  Frame frame(const Tie& tie, const std::vector<Point>& x) const;
  std::vector<Frame> frames(const std::vector<MovingBody>& bodies) const;
  std::vector<Point> gather(const std::vector<MovingBody>& bodies,
                            AlignedVector<double> MovingBody::*vector) const;
  /// y = G x, one entry for each tie; f = G^T l, one entry for each node.
  void apply(const std::vector<Frame>& frames, const std::vector<Point>& x, std::vector<Point>& y) const;
  void spread(const std::vector<Frame>& frames, const std::vector<Point>& l, std::vector<Point>& f) const;
  /// Solves S l = b.
  std::vector<Point> solve(const std::vector<Frame>& frames, const std::vector<Point>& b) const;

  int dim_ = 2;
  std::vector<Bond> bonds_;
  std::vector<Node> nodes_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> number_;  ///< (body, point) -> index into nodes_
  std::vector<Tie> ties_;
  std::vector<Point> force_;  ///< N, on each node
  double taken_ = 0;
};

}  // namespace femsph
