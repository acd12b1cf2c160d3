#pragma once
// Bodies that are bonded where they touch at the start: contacts of kind "tied".
//
// Points of one body, the finer one, stay at a material point of a facet of the other:
//   g = x - sum N_c x_c - g0 n = 0,   N_c the facet's shape functions there, n its normal, g0 the distance at
//   the start (0 where points meet).
// A penalty stiff enough not to be felt would shorten the step; here the forces that keep g = 0 at the end of
// the step are solved for (Lagrange multipliers of the central difference method: Carpenter, Taylor & Katona,
// Int. J. Numer. Meth. Engng 32 (1991) 103):
//   S l = -(g / dt + keep G v) / push - G M^-1 f,   S = G M^-1 G^T,   G = dg/dx,
// with keep and push as in Leap; the forces are G^T l. Motion as one solid changes no g, so G^T l
// has neither resultant nor moment, to round-off. Constraints only lower the frequencies of a system, so the
// step stays that of the bodies alone. S is diagonal where points meet points, and near that elsewhere:
// conjugate gradients, scaled by its diagonal, need a few turns.

#include <map>
#include <string>
#include <vector>

#include "model/motion/bodies/surface.hpp"
#include "model/numerics/archive.hpp"

namespace femsph {

class Ties {
 public:
  Ties() = default;
  /// Of all tied contacts of the scene. Throws MotionError if two bodies touch nowhere, or where a mean is
  /// held too.
  Ties(const Scene& scene, const std::vector<MovingBody>& bodies);

  bool empty() const { return bonds_.empty(); }
  /// Adds the forces that end the step dt with g = 0, last of all forces; `before` is the step that led here.
  /// `first`: nothing has moved yet, and velocities are not known.
  void add_forces(std::vector<MovingBody>& bodies, double keep, double push, double dt, double before,
                  bool first);
  /// What bodies lose that start at different speeds: impulses that make G v = 0.
  void match_velocities(std::vector<MovingBody>& bodies) const;

  /// One contact.
  struct Bond {
    const Contact* contact;
    std::size_t from, onto;  ///< whose points, whose facets: of the march's deformable bodies
    std::size_t begin, end;  ///< its ties
    Point force{};           ///< N, of the contact's first body on its second, now
  };
  const std::vector<Bond>& bonds() const { return bonds_; }
  double taken() const { return taken_; }  ///< J: minus the work of the forces so far; round-off where g0 = 0
  void state(Archive& archive) { archive("force", force_), archive("taken", taken_); }

 private:
  /// A point of some body that takes part.
  struct Node {
    std::size_t body, point;
    Point reference, inverse_mass;  ///< m, 1/kg: 0 where held
  };
  struct Tie {
    std::size_t node;
    std::array<std::size_t, 4> facet;
    std::array<double, 4> share, along, across;  ///< N_c and its derivatives along the facet's two directions
    double offset;                               ///< g0, m
    Point normal;                                ///< at the start
    int corners;
  };
  /// Directions of a facet as it lies now.
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
  /// y = G x, by ties; f = G^T l, by nodes.
  void apply(const std::vector<Frame>& frames, const std::vector<Point>& x, std::vector<Point>& y) const;
  void spread(const std::vector<Frame>& frames, const std::vector<Point>& l, std::vector<Point>& f) const;
  /// l with S l = b.
  std::vector<Point> solve(const std::vector<Frame>& frames, const std::vector<Point>& b) const;

  int dim_ = 2;
  std::vector<Bond> bonds_;
  std::vector<Node> nodes_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> number_;  ///< of a body's point among the nodes
  std::vector<Tie> ties_;
  std::vector<Point> force_;  ///< N, on each node
  double taken_ = 0;
};

}  // namespace femsph
