#pragma once
// Contact of two bodies by a penalty, one implementation for particles and nodes.
//
// A point that lies a depth g inside the other body is pushed out along that surface's normal n with
//   f = kappa A g n,         kappa = 0.25 factor min over the two bodies of rho c^2 / d,
// A = the area it stands for, seen along n. Two deformable bodies: points of each against facets of the
// other, with the weights w_1 + w_2 = 1 (half each for equal facets), so that an even depth is an even
// pressure kappa g. The opposite force acts at the foot of the point on the facet, shared out by shape
// functions: what one body gains in momentum and moment of momentum the other loses, to round-off. Against a
// rigid body the depth is that in its shape. Friction (Coulomb): a tangential spring of the same stiffness,
// whose stretch s follows the sliding until kappa A |s| = mu f.
//
// A stiffer penalty costs step size: the march includes it in the critical step (add_springs).

#include <string>
#include <vector>

#include "model/motion/bodies/surface.hpp"

namespace femsph {

class ContactPair {
 public:
  /// One of the two bodies: which of the march's deformable bodies, or which of its rigid ones.
  struct Party {
    bool rigid;
    std::size_t index;
  };
  /// `contact` must outlive the pair. Throws MotionError if a body has no boundary facets.
  ContactPair(const Scene& scene, const Contact& contact, const std::array<Party, 2>& parties,
              const std::vector<MovingBody>& bodies);

  /// Forces of the contact on both bodies at this step; `dt` is what the stretch of friction has grown by
  /// since the last call (0 at the first). Throws MotionError for bodies that overlap at step 0, and for
  /// points that went too deep.
  void add_forces(std::vector<MovingBody>& bodies, std::vector<RigidBody>& rigids, long step,
                  double step_size);

  /// Springs to ground (flat, N/m) on the points of deformable body `index` that bound the penalty: the
  /// springs between two sets of points are at most twice those on each, and (1 + theta), (1 + 1/theta) times
  /// on a body and on a rigid body; theta keeps the rigid body's part within `frequency2` (1/s^2), that of
  /// the body itself. Returns the largest step (s) that the rigid body allows.
  double add_springs(std::size_t index, const MovingBody& body, const std::vector<RigidBody>& rigids,
                     double frequency2, AlignedVector<double>& springs) const;

  void state(Archive& archive);
  const Contact& contact() const { return contact_; }
  double stiffness() const { return kappa_; }     ///< kappa, Pa/m
  double stored() const { return stored_; }       ///< J, now
  double friction_loss() const { return loss_; }  ///< J, so far
  const Point& force() const { return force_; }   ///< N, of the first body on the second, now
  double deepest() const { return deepest_; }     ///< m, so far
  double deepest_share() const { return deepest_ / spacing_; }
  std::size_t touching() const { return touching_; }  ///< points, now

 private:
  struct Side {
    Party party;
    std::vector<Surface> surface;  ///< one; none of a rigid body
  };
  /// What a point remembers from step to step: the piece nearest to it, whether it touches, and the stretch
  /// of its friction spring.
  struct Hold {
    int piece = -1;
    bool touches = false;
    Point stretch{};
    Point pull{};  ///< N, what the spring pulled at the last step
  };
  /// What the contact does to one point now. All points are looked at in parallel; their forces are then
  /// added up one after the other, in order, so that the sums do not depend on the threads.
  struct PointForce {
    enum class Kind { none, press, overlap, too_deep } kind = Kind::none;
    Stand at;
    Point force{};      ///< N, on the point
    double depth = 0;   ///< m
    double stored = 0;  ///< J
    double slip = 0;    ///< J, taken by friction since the last step
  };
  /// Points of sides_[from] against the surface of the other side.
  struct Pass {
    int from;
    double weight;
    std::vector<Hold> holds;          ///< of every surface point
    std::vector<std::size_t> points;  ///< those near the other body, and for each its pieces:
                                      ///< pieces[begin[k]] .. pieces[begin[k + 1] - 1]
    std::vector<int> begin, pieces;
    std::vector<PointForce> forces;  ///< of each of these points, now
  };
  struct Bodies {
    std::vector<MovingBody>& moving;
    std::vector<RigidBody>& rigid;
  };

  void search(Bodies bodies, long step, double dt);
  void search(Bodies bodies, Pass& pass);
  void refuse_overlap(Bodies bodies) const;
  void mark_active();
  Stand stand(Bodies bodies, const Pass& pass, int piece, const Point& x) const;
  /// The nearest piece that faces the point; false if none is near or the point is outside.
  bool choose(Bodies bodies, const Pass& pass, std::size_t k, Hold& hold, Stand& found) const;
  PointForce press(Bodies bodies, const Pass& pass, std::size_t k, Hold& hold, long step, double dt) const;
  void rub(Bodies bodies, const Pass& pass, std::size_t p, Hold& hold, double k, double pressing, double dt,
           PointForce& on_point) const;
  void release(Bodies bodies, const Pass& pass, std::size_t p, Hold& hold, double dt,
               PointForce& on_point) const;
  void apply(Bodies bodies, const Pass& pass, std::size_t k, long step);
  void react(Bodies bodies, const Pass& pass, int piece, const Stand& at, const Point& x, const Point& force);
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
