// Corrected SPH on scattered particles: a uniform stress is in balance with the tractions on the sides, to round-off; what the weights give up for
// that is nothing else: linear fields, momenta and energy stay exact.

#include <gtest/gtest.h>

#include <numeric>

#include "model/motion/vectors.hpp"
#include "model/scene/structured_shapes.hpp"
#include "sph_support.hpp"

namespace femsph::test {
namespace {

// Stress of `slope`: sigma = 2 mu e + lambda tr(e) I, the law's own numbers.
constexpr double slope[3][3] = {{3e-4, 1e-4, -2e-4}, {-2e-5, 5e-4, 6e-5}, {1e-4, -7e-5, -4e-4}};

struct Body {
  const char* name;
  std::shared_ptr<const Shape> shape;
  double spacing, smoothing = 1, jitter = 0;
  std::vector<const char*> planes{};
};

std::vector<Body> bodies() {
  using Part = Round::Part;
  const auto round = [](int dim, double inner, Part part) { return std::make_shared<Round>(dim, Round::Size{{}, inner, 0.1, dim == 3 ? 0.1 : 0, 2, part}); };
  const std::array<Point, 4> corners{Point{0, 0, 0}, {0.48, 0.44, 0}, {0.48, 0.6, 0}, {0, 0.44, 0}};
  return {{"jittered bar", std::make_shared<Box>(2, Point{}, Point{0.4, 0.1, 0}), 0.0125, 1, 0.2},
          {"jittered bar, h = 1.4 d", std::make_shared<Box>(2, Point{}, Point{0.4, 0.1, 0}), 0.0125, 1.4, 0.2},
          {"jittered block", std::make_shared<Box>(3, Point{}, Point{0.1, 0.06, 0.08}), 0.0125, 1, 0.2},
          {"disc of blocks", round(2, 0, Part::whole), 0.0125},
          {"disc of blocks, h = 1.4 d", round(2, 0, Part::whole), 0.0125, 1.4},
          {"ring", round(2, 0.05, Part::whole), 0.0125},
          {"quadrilateral", std::make_shared<Quadrilateral>(corners), 0.04},
          {"cylinder", round(3, 0, Part::whole), 0.025},
          {"ball", std::make_shared<OwnBall>(OwnBall::Size{{}, 0.1, 2, Part::whole, 1}), 0.025},
          {"ball, h = 1.4 d", std::make_shared<OwnBall>(OwnBall::Size{{}, 0.1, 2, Part::whole, 1}), 0.025, 1.4},
          {"quarter of a disc", round(2, 0, Part::quarter), 0.0125, 1, 0, {"x-", "y-"}},
          {"quarter of a cylinder", round(3, 0, Part::quarter), 0.02, 1, 0, {"x-", "y-", "z-"}}};
}

Scene scene_of(const Body& b, bool large = false) {
  Scene s = box_scene(b.shape->dim() == 2 ? Plane::strain : Plane::none, {1, 1, 1}, large);
  s.bodies[0].shape = b.shape;
  s.bodies[0].thickness = b.shape->dim() == 2 ? 0.5 : 1;
  for (const char* side : b.planes) s.symmetries.push_back({Place{0, {side}, {}, {}, {}}});
  return s;
}
std::unique_ptr<Discretization> particles_of(const Body& b, bool projection, bool large = false) {
  sph::Options o = corrected(b.spacing, b.smoothing);
  o.jitter = b.jitter, o.projection = projection;
  return sph::discretize(scene_of(b, large), 0, o);
}

/// Largest |f + t sigma a| over the largest |t sigma a|, without what symmetry planes hold: a are the corners' shares of the sides.
double imbalance(const Body& b, const Discretization& d, const AlignedVector<double>& f, const double (&sigma)[3][3], double thickness) {
  std::vector<Point> area(d.layout().points, Point{});
  for (const std::string& side : b.shape->sides()) {
    if (side == "x-" || side == "x+" || side == "y-" || side == "y+" || side == "z-" || side == "z+")
      if (std::find_if(b.planes.begin(), b.planes.end(), [&](const char* p) { return side == p; }) != b.planes.end()) continue;
    for (const PointArea& part : d.outward_areas({0, {side}, {}, {}, {}})) area[part.point] = area[part.point] + part.area;
  }
  double most = 0, off = 0;
  for (std::size_t i = 0; i < d.layout().points; ++i)
    for (int r = 0; r < d.layout().dim; ++r) {
      if (std::any_of(b.planes.begin(), b.planes.end(), [&](const char* p) { return p[0] - 'x' == r && std::abs(d.position(i)[std::size_t(r)]) < 1e-9; })) continue;
      double traction = 0;
      for (int c = 0; c < d.layout().dim; ++c) traction += sigma[r][c] * area[i][std::size_t(c)];
      most = std::max(most, std::abs(traction) * thickness);
      off = std::max(off, std::abs(f[d.layout().at(i, r)] + traction * thickness));
    }
  return off / most;
}

/// A linear field that symmetry planes allow, and its stress.
double imbalance_of(const Body& b, bool projection) {
  const auto d = particles_of(b, projection);
  const int dim = d->layout().dim;
  double A[3][3] = {}, sigma[3][3] = {}, trace = 0;
  for (int r = 0; r < dim; ++r)
    for (int c = 0; c < dim; ++c)
      if (b.planes.empty() || r == c) A[r][c] = slope[r][c];
  for (int r = 0; r < dim; ++r) trace += A[r][r];
  const Scene scene = scene_of(b);
  const auto law = std::get<LinearElastic>(scene.material_of(scene.bodies[0]).law(scene.plane));
  for (int r = 0; r < dim; ++r)
    for (int c = 0; c < dim; ++c) sigma[r][c] = law.mu * (A[r][c] + A[c][r]) + (r == c ? law.lambda * trace : 0);
  return imbalance(b, *d, force(*d, linear_vector(*d, A)), sigma, scene.bodies[0].thickness);
}

TEST(Projection, UniformStressBalancesItsTractions) {
  for (const Body& b : bodies()) {
    printf("%s: %g %g\n", b.name, imbalance_of(b, false), imbalance_of(b, true));
    EXPECT_LT(imbalance_of(b, true), 1e-11) << b.name;
    EXPECT_GT(imbalance_of(b, false), 0.01) << b.name;
  }
}

}  // namespace
}  // namespace femsph::test
