#include "model/motion/effects/gravity.hpp"

#include <algorithm>

#include "model/numerics/parallel.hpp"
#include "model/numerics/simd.hpp"
#include "model/numerics/vectors.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph {

namespace {

using namespace scene_reader;

constexpr std::size_t chunk = 4096;  ///< points, as in parallel_sum; a multiple of `lanes`
/// A point takes about a tenth of the time of a particle's forces. For fewer points than this, starting the
/// threads costs more than it saves.
constexpr std::size_t points_for_one_thread = 4 * serial_below;

/// The two layouts of flat vectors, with strides that the compiler knows: the components of a point side by
/// side (FEM), or one row for each component (SPH).
template <int dim>
struct SideBySide {
  std::size_t first;
  std::size_t at(std::size_t i, int c) const { return first + i * dim + std::size_t(c); }
};
template <int dim>
struct Rows {
  std::size_t first, stride;
  std::size_t at(std::size_t i, int c) const { return first + std::size_t(c) * stride + i; }
};

template <class Body>
auto with_strides(const Layout& at, Body&& body) {
  if (at.component_stride == 1 && at.point_stride == std::size_t(at.dim)) {
    if (at.dim == 2) return body.template operator()<2>(SideBySide<2>{at.offset});
    return body.template operator()<3>(SideBySide<3>{at.offset});
  }
  if (at.dim == 2) return body.template operator()<2>(Rows<2>{at.offset, at.component_stride});
  return body.template operator()<3>(Rows<3>{at.offset, at.component_stride});
}

/// Eight independent sums, so that no addition waits for the one before.
template <int dim, class Strides>
double power(const Strides at, const double* __restrict m, const Point& g, const double* __restrict v,
             std::size_t begin, std::size_t end) {
  double sum[lanes] = {};
  std::size_t i = begin;
  for (; i + lanes <= end; i += lanes)
    for (int l = 0; l < lanes; ++l) {
      double along = g[0] * v[at.at(i + std::size_t(l), 0)];
      for (int c = 1; c < dim; ++c) along += g[c] * v[at.at(i + std::size_t(l), c)];
      sum[l] += m[i + std::size_t(l)] * along;
    }
  for (; i < end; ++i)
    for (int c = 0; c < dim; ++c) sum[0] += m[i] * g[c] * v[at.at(i, c)];
  double all = 0;
  for (const double part : sum) all += part;
  return all;
}

KeyTable gravity_keys() {
  return {"[gravity]",
          "The acceleration of gravity, for all bodies.",
          {{"acceleration", key_holds::vector(dimension::acceleration),
            "Its components, such as [\"0 m/s^2\", \"-9.81 m/s^2\"].", true}}};
}

void read_gravity(Fields& root, Reading& reading) {
  auto gravity = root.table(
      "gravity", Need::optional, "a table with acceleration = [\"0 m/s^2\", \"-9.81 m/s^2\"] or the like");
  if (!gravity) return;
  const auto acceleration = gravity->vector(
      "acceleration", Need::required, dimension::acceleration, reading.dim);
  if (acceleration && *acceleration != Point{})
    reading.scene.gravity = acceleration;  // zero is no gravity: it costs nothing
  gravity->done();
}

}  // namespace

void add_weight(const Layout& layout, std::span<const double> mass, const Point& g, double* f) {
  const double* m = mass.data();
  with_strides(layout, [&]<int dim>(const auto at) {
    const auto add = [=, g = g](std::size_t begin, std::size_t end) {
      const double* __restrict own = m;
      double* __restrict force = f;
      for (std::size_t i = begin; i < end; ++i)
        for (int c = 0; c < dim; ++c) force[at.at(i, c)] += own[i] * g[c];
    };
    if (layout.points < points_for_one_thread)
      add(0, layout.points);
    else
      parallel_for(layout.points, 512, add);
  });
}

double power_of_weight(const Layout& layout, std::span<const double> mass, const Point& g, const double* v) {
  const double* m = mass.data();
  return with_strides(layout, [&]<int dim>(const auto at) {
    const auto part = [&](std::size_t begin, std::size_t end) { return power<dim>(at, m, g, v, begin, end); };
    if (layout.points >= points_for_one_thread) return parallel_sum(layout.points, part);
    double sum = 0;
    for (std::size_t begin = 0; begin < layout.points; begin += chunk)
      sum += part(begin, std::min(begin + chunk, layout.points));
    return sum;
  });
}

/// A rigid body adds its weight itself (RigidBody::begin_forces).
Gravity::Gravity(Motion& motion) : g_(*motion.scene.gravity) {
  for (RigidBody& body : motion.rigid) body.gravity = g_;
}

void Gravity::push_body(const Motion&, MovingBody& body) {
  const Discretization& d = *body.discretization;
  add_weight(d.layout(), d.mass(), g_, body.f.data());
}

void Gravity::work_on_body(const Motion& motion, const MovingBody& body, double& work) const {
  const Discretization& d = *body.discretization;
  work += motion.dt * power_of_weight(d.layout(), d.mass(), g_, body.v.data());
}

void Gravity::work_on_rigid(const Motion& motion, const RigidBody& body, double& work) const {
  work += body.mass * motion.dt * dot(g_, body.velocity);
}

void Gravity::each_force(const Motion&, const MovingBody& body, const TakeForce& take) const {
  const std::span<const double> mass = body.discretization->mass();
  for (std::size_t i = 0; i < mass.size(); ++i) take(i, mass[i] * g_);
}

void Gravity::size_on_body(const Motion&, const MovingBody& body, double& sum) const {
  for (const double m : body.discretization->mass()) sum += m * sum_of_magnitudes(g_);
}

EffectEntry gravity_effect() {
  EffectEntry e{{"gravity", "the weight m g of every node or particle"}};
  e.asked_by = "[gravity]";
  e.on = [](const Scene& s) { return s.gravity.has_value(); };
  e.tables = {gravity_keys()};
  e.read = read_gravity;
  e.outside = true;
  e.make = make_effect<Gravity>;
  return e;
}

}  // namespace femsph
