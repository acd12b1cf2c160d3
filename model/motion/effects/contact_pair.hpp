#pragma once
// Contact of two bodies by a penalty method, the same for particles and nodes ("points").
//
// A point at a depth g inside the other body is pushed out along the normal n of that body's surface with
//   f = kappa A g n,         kappa = 0.25 factor min over the two bodies of rho c^2 / d,
// where d is the spacing and A the surface area of the point, projected along n. Between two deformable
// bodies there are two passes, points of each body against facets of the other, with weights w_1 + w_2 = 1
// (1/2 each for facets of equal size), so that a uniform depth gives a uniform pressure kappa g. The opposite
// force acts at the closest point on the facet and is distributed by its shape functions, so that linear and
// angular momentum are conserved to round-off. Against a rigid body, g is the depth inside its shape. Coulomb
// friction: a tangential spring of the same stiffness, whose stretch s follows the sliding motion up to kappa
// A |s| = mu f.
//
// A stiffer penalty reduces the critical time step, which includes it (add_springs).

#include <string>
#include <vector>

#include "model/motion/bodies/surface.hpp"

namespace femsph {

class ContactPair {
 public:
  /// One of the two bodies: its index among the deformable bodies, or among the rigid ones.
  struct Party {
    bool rigid;
    std::size_t index;
  };
  /// `contact` must outlive the pair. Throws MotionError if a body has no boundary facets.
  ContactPair(const Scene& scene, const Contact& contact, const std::array<Party, 2>& parties,
              const std::vector<MovingBody>& bodies);

  /// Adds the contact forces on both bodies at this step. `step_size` (s) is the step that led here, over
  /// which the friction springs are stretched. Throws MotionError for bodies that overlap at step 0, and for
  /// points that have penetrated too deep.
  void add_forces(std::vector<MovingBody>& bodies, std::vector<RigidBody>& rigids, long step,
                  double step_size);

  /// Adds springs to ground (N/m, flat) on the points of deformable body `index` that bound the penalty
  /// springs from above. For any theta > 0, k (a - b)^2 <= (1 + theta) k a^2 + (1 + 1/theta) k b^2: springs
  /// between the points of two bodies are bounded by springs to ground, twice as stiff on each (theta = 1),
  /// or (1 + theta) times on the deformable and (1 + 1/theta) times on a rigid body. There theta is chosen
  /// such that the frequency of the rigid body stays within `frequency2` (1/s^2), that of the deformable body
  /// alone. Returns the largest step (s) that the rigid body allows.
  double add_springs(std::size_t index, const MovingBody& body, const std::vector<RigidBody>& rigids,
                     double frequency2, AlignedVector<double>& springs) const;

  void state(Archive& archive);
  const Contact& contact() const { return contact_; }
  double stiffness() const { return kappa_; }     ///< kappa, Pa/m
  double stored() const { return stored_; }       ///< energy in penalty and friction springs now, J
  double friction_loss() const { return loss_; }  ///< energy dissipated so far, J
  const Point& force() const { return force_; }   ///< N, of the first body on the second, now
  double deepest() const { return deepest_; }     ///< largest depth so far, m
  double deepest_share() const { return deepest_ / spacing_; }
  std::size_t touching() const { return touching_; }  ///< number of points in contact now

 private:
  struct Side {
    Party party;
    std::vector<Surface> surface;  ///< one for a deformable body, none for a rigid one
  };
  /// What is kept of a point from step to step.
  struct PointHistory {
    int piece = -1;  ///< the facet (or side of a rigid body) nearest to it; -1: none
    bool touches = false;
    Point stretch{};  ///< m, of its friction spring
    Point pull{};     ///< N, the force of that spring at the last step
  };
  /// The contact force on one point at the present step. These are computed for all points in parallel, and
  /// then added up one after the other in order, so that the sums do not depend on the number of threads.
  struct PointForce {
    enum class Kind { none, press, overlap, too_deep } kind = Kind::none;
    Projection at;
    Point force{};      ///< N
    double depth = 0;   ///< m
    double stored = 0;  ///< J
    double slip = 0;    ///< J, dissipated by friction since the last step
  };
  /// The points of sides_[from] against the surface of the other side.
  struct Pass {
    int from;
    double weight;
    std::vector<PointHistory> histories;  ///< one for every surface point
    std::vector<std::size_t> points;      ///< the points near the other body; near point k are the pieces
                                          ///< pieces[begin[k]] .. pieces[begin[k + 1] - 1]
    std::vector<int> begin, pieces;
    std::vector<PointForce> forces;  ///< one for each of these points
  };
  struct Bodies {
    std::vector<MovingBody>& moving;
    std::vector<RigidBody>& rigid;
  };

  void search(Bodies bodies, long step, double dt);
  void search(Bodies bodies, Pass& pass);
  void refuse_overlap(Bodies bodies) const;
  void mark_active();
  Projection project(Bodies bodies, const Pass& pass, int piece, const Point& x) const;
  /// Finds the nearest piece that faces the point; false if none is near, or if the point is outside of the
  /// body.
  bool find_piece(Bodies bodies, const Pass& pass, std::size_t k, PointHistory& history,
                  Projection& found) const;
  PointForce force_on_point(Bodies bodies, const Pass& pass, std::size_t k, PointHistory& history, long step,
                            double dt) const;
  void add_friction(Bodies bodies, const Pass& pass, std::size_t p, PointHistory& history, double k,
                    double pressing, double dt, PointForce& on_point) const;
  void release(Bodies bodies, const Pass& pass, std::size_t p, PointHistory& history, double dt,
               PointForce& on_point) const;
  void apply(Bodies bodies, const Pass& pass, std::size_t k, long step);
  void apply_reaction(Bodies bodies, const Pass& pass, int piece, const Projection& at, const Point& x,
                      const Point& force);
  [[noreturn]] void fail(const std::string& what, const Point& at) const;

  const Scene& scene_;
  const Contact& contact_;
  std::array<Side, 2> sides_;
  std::vector<Pass> passes_;
  double kappa_ = 0, spacing_ = 0, wave_speed_ = 0;
  double skin_ = 0, depth_ = 0, overhang_ = 0, slack_ = 0;  ///< m
  long next_search_ = 0;
  double stored_ = 0, loss_ = 0, deepest_ = 0;
  std::size_t touching_ = 0;
  Point force_{};
};

}  // namespace femsph
