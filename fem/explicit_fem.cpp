#include "fem/explicit_fem.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "fem/fem.hpp"
#include "fem/mesh/geometry.hpp"
#include "model/numerics/least_squares.hpp"
#include "model/numerics/parallel.hpp"

namespace femsph::fem {

namespace {

std::string in_short(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

/// "fem-one-point and fem-assumed-strain"
std::string methods_that_do_not_lock() {
  std::vector<std::string> words;
  for (const ElementEntry& entry : elements())
    if (!entry.locks_in_volume) words.push_back(std::string("fem-") + entry.word);
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
    text += (k == 0 ? "" : k + 1 == words.size() ? " and " : ", ") + words[k];
  return text;
}

Mesh checked_mesh(const Scene& scene, const Shape& shape, const Options& options) {
  if (shape.dim() != scene.dim())
    throw Refusal("the scene is " + std::to_string(scene.dim()) + "D but its body is " + shape.describe());
  Mesh mesh = make_mesh(shape, options.divisions, options.distortion);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < mesh.corners(); ++q)
      if (!(jacobian(mesh, c, q) > 0)) {
        const Point p = map_point(mesh, c, {});
        throw Refusal((mesh.cell_numbers.empty() ? "a cell" : mesh.cell_name(c)) + " at (" +
                      std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) +
                      ") m is folded: its volume is not positive everywhere");
      }
  return mesh;
}

Layout interleaved(const Mesh& mesh, const Batches& batches) {
  const std::size_t dim = static_cast<std::size_t>(mesh.dim);
  return {mesh.node_count(), mesh.dim, dim, 1, 0, round_up(batches.slots * dim, lanes)};
}

}  // namespace

ExplicitFem::ExplicitFem(const Scene& scene, std::size_t body, const Options& options)
    : shape_(scene.bodies.at(body).shape),
      element_(element_named(options.element)),
      hourglass_(options.hourglass),
      thickness_(scene.dim() == 2 ? scene.bodies[body].thickness : 1.0),
      plane_(scene.plane),
      mesh_(checked_mesh(scene, *shape_, options)),
      batches_(mesh_),
      layout_(interleaved(mesh_, batches_)),
      spacing_(shortest_edge(mesh_)),
      locator_(mesh_, shape_->is_round() ? 0.2 : 0.0),
      law_(scene.material_of(scene.bodies[body]).law(scene.plane)) {
  const Material& material = scene.material_of(scene.bodies[body]);
  mass_ = lumped_mass(mesh_, material.density, thickness_);
  std::vector<Point> nodes(mesh_.node_count());
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = mesh_.node(i);
  const std::vector<BarRow> rows = bar_rows(scene, body, nodes, 1e-6 * spacing_);
  bars_ = TrussBars(rows, nodes, mesh_.dim, scene.large_motion);
  bars_.add_mass(mass_);
  bars_text_ = femsph::describe(rows, scene);
  yields_ = material.yields();
  wave_speed_ = std::visit([](const auto& l) { return l.wave_speed(); }, law_);
  const auto make = options.loop ? options.loop : make_loop;
  loop_ = make(element_.word, {&mesh_, &batches_, law_, thickness_, options.hourglass, scene.large_motion});
}

std::string ExplicitFem::describe() const {
  return "explicit FEM, " + std::to_string(mesh_.cell_count()) +
         (mesh_.dim == 2 ? " quadrilaterals, " : " hexahedra, ") + element_.name +
         (!element_.hourglass_control ? ""
          : hourglass_                ? ", hourglass coefficient " + in_short(*hourglass_)
                                      : std::string(", ") + element_.hourglass_control) +
         bars_text_;
}

/// Volumetric locking: where the material keeps its volume, each of the 8 (in 2D 4) integration points adds
/// one constraint, more than the displacements of the corners can fulfil. Reduced integration of the shear
/// does not help. In plane stress the thickness is free to change, and nothing locks.
std::vector<std::string> ExplicitFem::warnings() const {
  const double poisson = std::visit([](const auto& l) { return l.elastic().poisson; }, law_);
  if (plane_ == Plane::stress || !element_.locks_in_volume || (poisson <= 0.45 && !yields_)) return {};
  const bool fluid = std::visit([](const auto& l) { return l.elastic().mu == 0; }, law_);
  std::string why = fluid     ? "a fluid resists a change of volume alone"
                    : yields_ ? "plastic flow keeps the volume"
                              : "";
  if (poisson > 0.45 && !fluid)
    why = "Poisson's ratio is " + in_short(poisson) + (yields_ ? ", and " + why : "");
  return {why + ": " + element_.name + " locks in volume, and displacements may be far too small; " +
          methods_that_do_not_lock() + " do not"};
}

std::size_t ExplicitFem::bytes() const {
  return sizeof(double) * (mesh_.nodes.capacity() + mass_.capacity()) +
         sizeof(std::size_t) * mesh_.cell_numbers.capacity() +
         sizeof(int) * (mesh_.cells.capacity() + mesh_.vertex.capacity()) + batches_.bytes() +
         locator_.bytes() + loop_->bytes() + bars_.bytes();
}

/// In parallel, as clearing is not negligible: a 2D elastic kernel takes only about ten times as long.
void ExplicitFem::clear(double* f) const {
  parallel_for(layout_.points, 512, [&](std::size_t begin, std::size_t end) {
    const std::size_t dim = static_cast<std::size_t>(layout_.dim);
    std::fill(f + begin * dim, end == layout_.points ? f + layout_.size : f + end * dim, 0.0);
  });
}

Energies ExplicitFem::energies(const double* u) const {
  Energies held = loop_->energies(u);
  held.strain += bars_.strain_energy(u);
  held.plastic += bars_.dissipated_energy();
  return held;
}

void ExplicitFem::internal_force(const double* u, const double*, double dt, double* f, double*) {
  clear(f);
  loop_->set_step(dt);
  std::visit(
      [&](auto& l) {
        if constexpr (requires { l.set_step(dt); }) l.set_step(dt);
      },
      law_);
  loop_->add_force(u, f);
  batches_.sum_ghosts(f, mesh_.dim);
  bars_.add_force(u, f);
}

void ExplicitFem::stiffness(const double* x, double* y) const {
  clear(y);
  loop_->add_stiffness(x, y);
  batches_.sum_ghosts(y, mesh_.dim);
  bars_.add_stiffness(x, y);
}

std::vector<Weight> ExplicitFem::points_of(const Place& place) const {
  return place_weights(mesh_, *shape_, place, mass_, 1e-6 * spacing_);
}

std::vector<Weight> ExplicitFem::interpolation(const Point& p) const {
  const auto [cell, xi] = locator_.find(p);
  const auto N = shape_functions(mesh_.dim, xi);
  std::vector<Weight> r;
  for (int a = 0; a < mesh_.corners(); ++a)
    if (N[a] != 0) r.push_back({static_cast<std::size_t>(mesh_.cell(cell)[a]), N[a]});
  return r;
}

Point ExplicitFem::material_position(std::size_t point) const {
  const std::size_t n = static_cast<std::size_t>(loop_->points_per_cell());
  return map_point(
      mesh_, point / n, n == 1 ? Point{} : gauss_coordinates(mesh_.dim, static_cast<int>(point % n)));
}

double ExplicitFem::material_volume(std::size_t point) const {
  const std::size_t n = static_cast<std::size_t>(loop_->points_per_cell());
  if (!loop_->equal_volumes()) return thickness_ * jacobian(mesh_, point / n, static_cast<int>(point % n));
  double v = 0;
  for (int q = 0; q < mesh_.corners(); ++q) v += jacobian(mesh_, point / n, q);
  return thickness_ * v / static_cast<double>(n);
}

std::vector<Weight> ExplicitFem::material_interpolation(const Point& p) const {
  const std::size_t n = static_cast<std::size_t>(loop_->points_per_cell());
  if (n == 1) {
    std::vector<Point> centres(mesh_.cell_count());
    for (std::size_t c = 0; c < centres.size(); ++c) centres[c] = map_point(mesh_, c, {});
    return least_squares_weights(centres, mesh_.dim, p, 1.6 * spacing_, 1e-6 * spacing_);
  }
  const std::vector<Locator::Found> cells = locator_.find_all(p);
  std::vector<Weight> r;
  for (const auto& [cell, xi] : cells) {
    Point stretched{};  // the Gauss points are the corners of a cell 1/sqrt(3) times as large
    for (int d = 0; d < mesh_.dim; ++d) stretched[d] = std::sqrt(3.0) * xi[d];
    const auto N = shape_functions(mesh_.dim, stretched);
    for (std::size_t q = 0; q < n; ++q) r.push_back({cell * n + q, N[q] / static_cast<double>(cells.size())});
  }
  return r;
}

/// A unit is a cell: the strain of all these elements is most accurate as the mean over the cell (Barlow,
/// Int. J. Numer. Meth. Engng 10, 1976). Its shape is sum_d e_d (x) e_d, where e_d = 2 dx/dxi_d at the centre
/// are the mean edges.
MaterialUnits ExplicitFem::material_units() const {
  MaterialUnits units;
  units.dim = mesh_.dim;
  units.points_per_unit = static_cast<std::size_t>(loop_->points_per_cell());
  units.place.resize(material_points());
  units.volume.resize(material_points());
  units.shape.resize(mesh_.cell_count());
  parallel_for(mesh_.cell_count(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t q = begin * units.points_per_unit; q < end * units.points_per_unit; ++q)
      units.place[q] = material_position(q), units.volume[q] = material_volume(q);
    for (std::size_t c = begin; c < end; ++c) {
      units.shape[c] = {};
      for (int d = 0; d < mesh_.dim; ++d) {
        Point edge{};  // 2 dx/dxi_d at the centre
        for (int a = 0; a < mesh_.corners(); ++a)
          for (int i = 0; i < mesh_.dim; ++i)
            edge[i] += (a >> d & 1 ? 2.0 : -2.0) / mesh_.corners() * mesh_.node(mesh_.cell(c)[a])[i];
        for (int i = 0; i < mesh_.dim; ++i)
          for (int j = i; j < mesh_.dim; ++j)
            units.shape[c][static_cast<std::size_t>(symmetric_index<3>(i, j))] += edge[i] * edge[j];
      }
    }
  });
  return units;
}

void ExplicitFem::material_state(const double* u, std::span<const std::size_t> points,
                                 MaterialState& out) const {
  const std::size_t n = static_cast<std::size_t>(loop_->points_per_cell());
  out.stress.resize(points.size());
  out.strain.resize(points.size());
  out.plastic.resize(yields_ ? points.size() : 0);
  out.resize_flow(std::visit([](const auto& l) { return plasticity_of(l); }, law_), points.size());
  parallel_for(points.size(), n * lanes, [&](std::size_t begin, std::size_t end) {
    std::array<Sample, 8> cell;
    std::size_t known = std::numeric_limits<std::size_t>::max();
    for (std::size_t k = begin; k < end; ++k) {
      if (points[k] / n != known) {
        known = points[k] / n;
        loop_->samples(u, known, known + 1, cell.data());
      }
      const Sample& sample = cell[points[k] % n];
      out.stress[k] = sample.stress;
      out.strain[k] = sample.strain;
      if (!yields_) continue;
      out.plastic[k] = sample.plastic;
      out.set_flow(k, sample.flow);
    }
  });
}

Topology ExplicitFem::topology() const {
  constexpr std::array<int, 8> vtk{0, 1, 3, 2, 4, 5, 7, 6};  // lexicographic corner of VTK's n-th point
  Topology t;
  t.kind = mesh_.dim == 2 ? Topology::Kind::quadrilaterals : Topology::Kind::hexahedra;
  t.cells.resize(mesh_.cell_count());
  for (std::size_t c = 0; c < mesh_.cell_count(); ++c)
    for (int a = 0; a < mesh_.corners(); ++a) t.cells[c][a] = static_cast<std::size_t>(mesh_.cell(c)[vtk[a]]);
  return t;
}

std::unique_ptr<Discretization> discretize(const Scene& scene, std::size_t body, const Options& options) {
  return std::make_unique<ExplicitFem>(scene, body, options);
}

}  // namespace femsph::fem
