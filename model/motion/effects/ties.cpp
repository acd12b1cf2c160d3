#include "model/motion/effects/ties.hpp"

#include <algorithm>
#include <cmath>

#include "model/motion/bodies/motion.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

Ties::Frame Ties::frame(const Tie& tie, const std::vector<Point>& x) const {
  Frame f;
  for (int c = 0; c < tie.corners; ++c) {
    f.along = f.along + tie.along[c] * x[tie.facet[c]];
    f.across = f.across + tie.across[c] * x[tie.facet[c]];
  }
  if (dim_ == 2) f.across = {0, 0, 1};
  f.normal = cross(f.along, f.across);
  f.size = norm(f.normal);
  f.normal = (1 / f.size) * f.normal;
  return f;
}

std::vector<Point> Ties::gather(const std::vector<MovingBody>& bodies,
                                AlignedVector<double> MovingBody::*vector) const {
  std::vector<Point> out(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const MovingBody& body = bodies[nodes_[k].body];
    for (int c = 0; c < dim_; ++c)
      out[k][c] = (body.*vector)[body.discretization->layout().at(nodes_[k].point, c)];
  }
  return out;
}

std::vector<Ties::Frame> Ties::frames(const std::vector<MovingBody>& bodies) const {
  std::vector<Point> x = gather(bodies, &MovingBody::u);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = x[k] + nodes_[k].reference;
  std::vector<Frame> out;
  for (const Tie& tie : ties_) out.push_back(tie.offset == 0 ? Frame{} : frame(tie, x));
  return out;
}

// n = m / |m| with m = along x across, so dn = (1 - n n) (d along x across + along x d across) / |m|.
void Ties::apply(const std::vector<Frame>& frames, const std::vector<Point>& x, std::vector<Point>& y) const {
  for (std::size_t k = 0; k < ties_.size(); ++k) {
    const Tie& tie = ties_[k];
    Point sum = x[tie.node], along{}, across{};
    for (int c = 0; c < tie.corners; ++c) {
      sum = sum - tie.share[c] * x[tie.facet[c]];
      along = along + tie.along[c] * x[tie.facet[c]];
      across = across + tie.across[c] * x[tie.facet[c]];
    }
    if (tie.offset != 0) {
      const Frame& f = frames[k];
      const Point turn = cross(along, f.across) + cross(f.along, across);
      sum = sum - (tie.offset / f.size) * (turn - dot(turn, f.normal) * f.normal);
    }
    y[k] = sum;
  }
}

void Ties::spread(const std::vector<Frame>& frames, const std::vector<Point>& l,
                  std::vector<Point>& force) const {
  std::fill(force.begin(), force.end(), Point{});
  for (std::size_t k = 0; k < ties_.size(); ++k) {
    const Tie& tie = ties_[k];
    force[tie.node] = force[tie.node] + l[k];
    Point along{}, across{};
    if (tie.offset != 0) {
      const Frame& f = frames[k];
      const Point w = (tie.offset / f.size) * (l[k] - dot(l[k], f.normal) * f.normal);
      along = cross(f.across, w);
      across = cross(w, f.along);
    }
    for (int c = 0; c < tie.corners; ++c)
      force[tie.facet[c]] = force[tie.facet[c]] - tie.share[c] * l[k] - tie.along[c] * along -
                            tie.across[c] * across;
  }
  if (dim_ == 2)
    for (Point& f : force) f[2] = 0;
}

namespace {

double dot(const std::vector<Point>& a, const std::vector<Point>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += femsph::dot(a[k], b[k]);
  return sum;
}

}  // namespace

std::vector<Point> Ties::solve(const std::vector<Frame>& frames, const std::vector<Point>& b) const {
  const std::size_t n = ties_.size();
  std::vector<Point> l(n), r = b, z(n), p(n), q(n), scale(n), on_nodes(nodes_.size());
  for (std::size_t k = 0; k < n; ++k)
    for (int c = 0; c < dim_; ++c) {
      double s = nodes_[ties_[k].node].inverse_mass[c];
      for (int a = 0; a < ties_[k].corners; ++a)
        s += ties_[k].share[a] * ties_[k].share[a] * nodes_[ties_[k].facet[a]].inverse_mass[c];
      scale[k][c] = s > 0 ? 1 / s : 0;  // both sides are held: no force is needed
      if (s == 0) r[k][c] = 0;
    }
  const auto precondition = [&] {
    for (std::size_t k = 0; k < n; ++k)
      for (int c = 0; c < 3; ++c) z[k][c] = scale[k][c] * r[k][c];
  };
  precondition();
  p = z;
  double rz = dot(r, z);
  const double enough = 1e-28 * rz;  // relative to its square: l to 14 digits
  for (int turn = 0; turn < 300 && rz > enough; ++turn) {
    spread(frames, p, on_nodes);
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      for (int c = 0; c < 3; ++c) on_nodes[k][c] *= nodes_[k].inverse_mass[c];
    apply(frames, on_nodes, q);
    const double pq = dot(p, q);
    if (!(pq > 0)) break;
    const double step = rz / pq;
    for (std::size_t k = 0; k < n; ++k) l[k] = l[k] + step * p[k], r[k] = r[k] - step * q[k];
    precondition();
    const double next = dot(r, z);
    for (std::size_t k = 0; k < n; ++k) p[k] = z[k] + (next / rz) * p[k];
    rz = next;
  }
  return l;
}

void Ties::add_forces(std::vector<MovingBody>& bodies, double keep, double push, double dt,
                      double step_before, bool first) {
  const std::vector<Frame> frames = this->frames(bodies);
  const std::vector<Point> u = gather(bodies, &MovingBody::u), v = gather(bodies, &MovingBody::v);
  // The right-hand side -b: what the step would give without ties, (g / dt + keep G v) / push + G M^-1 f.
  std::vector<Point> move = gather(bodies, &MovingBody::f), b(ties_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const MovingBody& body = bodies[nodes_[k].body];
    for (int c = 0; c < dim_; ++c) {
      if (!body.viscous.empty())
        move[k][c] += body.viscous[body.discretization->layout().at(nodes_[k].point, c)];
      move[k][c] *= nodes_[k].inverse_mass[c];
    }
    if (!first) move[k] = move[k] + (keep / push) * v[k];
  }
  apply(frames, move, b);
  for (std::size_t k = 0; k < ties_.size(); ++k) {
    const Tie& tie = ties_[k];
    Point g = u[tie.node];
    for (int c = 0; c < tie.corners; ++c) g = g - tie.share[c] * u[tie.facet[c]];
    if (tie.offset != 0) g = g - tie.offset * (frames[k].normal - tie.normal);
    b[k] = -1.0 * (b[k] + (1 / (dt * push)) * g);
  }
  const std::vector<Point> l = solve(frames, b), before = force_;
  spread(frames, l, force_);
  double work = 0;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    MovingBody& body = bodies[nodes_[k].body];
    for (int c = 0; c < dim_; ++c)
      body.f[body.discretization->layout().at(nodes_[k].point, c)] += force_[k][c];
    work += femsph::dot(v[k], before[k] + force_[k]);
  }
  if (!first) taken_ -= 0.5 * step_before * work;
  for (Bond& bond : bonds_) {
    Point sum{};
    for (std::size_t k = bond.begin; k < bond.end; ++k) sum = sum + l[k];
    bond.force = (bodies[bond.from].index == bond.contact->between[1] ? 1.0 : -1.0) * sum;
  }
}

void Ties::match_velocities(std::vector<MovingBody>& bodies) const {
  const std::vector<Frame> frames = this->frames(bodies);
  std::vector<Point> b(ties_.size()), impulse(nodes_.size());
  apply(frames, gather(bodies, &MovingBody::v), b);
  for (Point& one : b) one = -1.0 * one;
  spread(frames, solve(frames, b), impulse);
  for (std::size_t k = 0; k < nodes_.size(); ++k)
    for (int c = 0; c < dim_; ++c)
      bodies[nodes_[k].body].v[bodies[nodes_[k].body].discretization->layout().at(nodes_[k].point, c)] +=
          nodes_[k].inverse_mass[c] * impulse[k][c];
}

}  // namespace femsph
