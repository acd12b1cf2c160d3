// Static linear elasticity with elements of high degree: the number that the cantilevers of both solvers
// converge to.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "fem/limit/limit.hpp"
#include "fem/limit/triangulation.hpp"
#include "model/numerics/principal.hpp"

namespace femsph::fem {

namespace {

template <int dim>
class StaticSolver {
 public:
  StaticSolver(const Scene& scene, const std::array<int, 3>& divisions, int degree)
      : scene_(scene),
        body_(scene.bodies.at(0)),
        law_(elastic_of(scene, 0, "the static limit")),
        thickness_(dim == 2 ? body_.thickness : 1.0),
        fe_(dealii::FE_Q<dim>(static_cast<unsigned int>(degree)), dim),
        dofs_(triangulation_) {
    make_triangulation<dim>(*body_.shape, divisions, 0.0, triangulation_);
    tolerance_ = 1e-6 * dealii::GridTools::minimal_cell_diameter(triangulation_);
    dofs_.distribute_dofs(fe_);
    support_points_.resize(dofs_.n_dofs());
    dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<dim>(), dofs_, support_points_);
    component_.resize(dofs_.n_dofs());
    std::vector<dealii::types::global_dof_index> global(fe_.n_dofs_per_cell());
    for (const auto& cell : dofs_.active_cell_iterators()) {
      cell->get_dof_indices(global);
      for (unsigned int i = 0; i < global.size(); ++i)
        component_[global[i]] = fe_.system_to_component_index(i).first;
    }
  }

  StaticLimit solve() {
    constrain();
    dealii::DynamicSparsityPattern pattern(dofs_.n_dofs());
    dealii::DoFTools::make_sparsity_pattern(dofs_, pattern, constraints_, false);
    pattern_.copy_from(pattern);
    matrix_.reinit(pattern_);
    load_.reinit(dofs_.n_dofs());
    solution_.reinit(dofs_.n_dofs());
    dealii::Vector<double> force(dofs_.n_dofs());
    for (const Load& load : scene_.loads) add_load(load, force);
    assemble(force);
    solve_system();
    constraints_.distribute(solution_);
    return read();
  }

 private:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  static Point to_point(const dealii::Point<dim>& p) {
    Point r{};
    for (int d = 0; d < dim; ++d) r[d] = p[d];
    return r;
  }
  static dealii::Point<dim> from_point(const Point& p) {
    dealii::Point<dim> r;
    for (int d = 0; d < dim; ++d) r[d] = p[d];
    return r;
  }
  bool on(const Place& place, const dealii::Point<dim>& p) const {
    if (place.within && !place.within->contains(to_point(p), tolerance_)) return false;
    return std::all_of(place.sides.begin(), place.sides.end(), [&](const std::string& side) {
      return body_.shape->on_side(side, to_point(p), tolerance_);
    });
  }

  /// Degrees of freedom of the support point nearest to p.
  std::vector<dealii::types::global_dof_index> nearest(const Point& p) const {
    double best = std::numeric_limits<double>::max();
    std::vector<dealii::types::global_dof_index> r;
    for (dealii::types::global_dof_index i = 0; i < support_points_.size(); ++i) {
      const double d = support_points_[i].distance(from_point(p));
      if (d < best - tolerance_) {
        best = d;
        r.clear();
      }
      if (d <= best + tolerance_ &&
          (r.empty() || support_points_[i].distance(support_points_[r[0]]) < tolerance_))
        r.push_back(i);
    }
    return r;
  }

  void constrain() {
    for (const Support& support : scene_.holds()) {
      const auto fix = [&](dealii::types::global_dof_index i) {
        if (support.fixed[component_[i]]) constraints_.add_line(i);
      };
      if (support.place.point) {
        for (const auto i : nearest(*support.place.point)) fix(i);
      } else {
        for (dealii::types::global_dof_index i = 0; i < support_points_.size(); ++i)
          if (on(support.place, support_points_[i])) fix(i);
      }
    }
    constraints_.close();
  }

  /// Adds weight times the shape functions of a cell at a reference point: one quadrature point of a load.
  void add_point(const Cell& cell, const dealii::Point<dim>& xi, double weight,
                 std::vector<double>& share) const {
    std::vector<dealii::types::global_dof_index> global(fe_.n_dofs_per_cell());
    cell->get_dof_indices(global);
    for (unsigned int i = 0; i < global.size(); ++i) share[global[i]] += weight * fe_.shape_value(i, xi);
  }

  /// Distributes a load over its place: shape functions integrated over the faces, edges or vertices on it,
  /// or over the body.
  void add_load(const Load& load, dealii::Vector<double>& force) const {
    if (load.pressure != 0)
      throw std::runtime_error("the converged static limit takes forces, not a pressure");
    std::vector<double> share(dofs_.n_dofs(), 0.0);
    if (load.place.point) {
      for (const auto i : nearest(*load.place.point)) share[i] = 1;
    } else if (load.place.sides.empty()) {
      over_body(share);
    } else {
      const int dimension = dim - static_cast<int>(load.place.sides.size());
      if (dimension == dim - 1)
        over_faces(load.place, share);
      else if (dim == 3 && dimension == 1)
        over_lines(load.place, share);
      else
        for (dealii::types::global_dof_index i = 0; i < support_points_.size(); ++i)
          share[i] = on(load.place, support_points_[i]);
    }
    std::array<double, dim> total{};
    for (std::size_t i = 0; i < share.size(); ++i) total[component_[i]] += share[i];
    if (!(total[0] > 0)) throw std::runtime_error("a load of the static limit meets no point of the mesh");
    for (std::size_t i = 0; i < share.size(); ++i)
      force[i] += load.force[component_[i]] * load.history.factor.back() * share[i] / total[component_[i]];
  }

  void over_body(std::vector<double>& share) const {
    const dealii::QGauss<dim> rule(fe_.degree + 1);
    dealii::FEValues<dim> values(fe_, rule, dealii::update_JxW_values);
    for (const auto& cell : dofs_.active_cell_iterators()) {
      values.reinit(cell);
      for (unsigned int q = 0; q < rule.size(); ++q) add_point(cell, rule.point(q), values.JxW(q), share);
    }
  }

  void over_faces(const Place& place, std::vector<double>& share) const {
    const dealii::QGauss<dim - 1> rule(fe_.degree + 1);
    dealii::FEFaceValues<dim> values(fe_, rule, dealii::update_JxW_values | dealii::update_quadrature_points);
    for (const auto& cell : dofs_.active_cell_iterators())
      for (const unsigned int face : cell->face_indices()) {
        if (!cell->face(face)->at_boundary()) continue;
        bool all = true;
        for (unsigned int v = 0; v < cell->face(face)->n_vertices(); ++v)
          all = all && on(place, cell->face(face)->vertex(v));
        if (!all) continue;
        values.reinit(cell, face);
        for (unsigned int q = 0; q < rule.size(); ++q)
          add_point(cell,
                    dealii::MappingQ1<dim>().transform_real_to_unit_cell(cell, values.quadrature_point(q)),
                    values.JxW(q), share);
      }
  }

  void over_lines(const Place& place, std::vector<double>& share) const {
    const dealii::QGauss<1> rule(fe_.degree + 1);
    std::set<std::array<unsigned int, 2>> done;
    for (const auto& cell : dofs_.active_cell_iterators())
      for (unsigned int line = 0; line < dealii::GeometryInfo<dim>::lines_per_cell; ++line) {
        const unsigned int v0 = dealii::GeometryInfo<dim>::line_to_cell_vertices(line, 0);
        const unsigned int v1 = dealii::GeometryInfo<dim>::line_to_cell_vertices(line, 1);
        if (!on(place, cell->vertex(v0)) || !on(place, cell->vertex(v1))) continue;
        if (!done.insert({std::min(cell->vertex_index(v0), cell->vertex_index(v1)),
                          std::max(cell->vertex_index(v0), cell->vertex_index(v1))})
                 .second)
          continue;
        const auto a = dealii::GeometryInfo<dim>::unit_cell_vertex(v0),
                   b = dealii::GeometryInfo<dim>::unit_cell_vertex(v1);
        for (unsigned int q = 0; q < rule.size(); ++q)
          add_point(cell, dealii::Point<dim>(a + rule.point(q)[0] * (b - a)),
                    rule.weight(q) * cell->vertex(v0).distance(cell->vertex(v1)), share);
      }
  }

  /// Cell matrices as one product of tall matrices, K = strain^T stress, rows running over points and
  /// components: degree 3 in 3D has 192 unknowns and 64 points a cell, and this goes through BLAS.
  void assemble(const dealii::Vector<double>& force) {
    constexpr int m = symmetric_size<dim>;
    const dealii::QGauss<dim> rule(fe_.degree + 1);
    dealii::FEValues<dim> values(
        fe_, rule, dealii::update_gradients | dealii::update_values | dealii::update_JxW_values);
    const dealii::FEValuesExtractors::Vector displacement(0);
    const unsigned int n = fe_.n_dofs_per_cell();
    dealii::FullMatrix<double> K(n, n), strain(m * rule.size(), n), stress(m * rule.size(), n);
    dealii::Vector<double> f(n);
    std::vector<dealii::types::global_dof_index> global(n);
    const Point g = scene_.gravity.value_or(Point{});
    for (const auto& cell : dofs_.active_cell_iterators()) {
      values.reinit(cell);
      f = 0;
      for (unsigned int q = 0; q < rule.size(); ++q)
        for (unsigned int i = 0; i < n; ++i) {
          const double w = thickness_ * values.JxW(q);
          const auto e = values[displacement].symmetric_gradient(i, q);
          const double pressure = law_.lambda * dealii::trace(e);
          for (int k = 0; k < dim; ++k)
            for (int l = k; l < dim; ++l) {
              const unsigned int row = q * m + static_cast<unsigned int>(symmetric_index<dim>(k, l));
              strain(row, i) = (k == l ? 1 : 2) * e[k][l];
              stress(row, i) = w * (2 * law_.mu * e[k][l] + (k == l ? pressure : 0.0));
            }
          f[i] += w * law_.density * g[fe_.system_to_component_index(i).first] * values.shape_value(i, q);
        }
      strain.Tmmult(K, stress);
      cell->get_dof_indices(global);
      constraints_.distribute_local_to_global(K, f, global, matrix_, load_);
    }
    for (dealii::types::global_dof_index i = 0; i < force.size(); ++i)
      if (!constraints_.is_constrained(i)) load_[i] += force[i];
  }

  /// Direct in 2D and for small solids; beyond that the fill is too much.
  void solve_system() {
    if (dim == 2 || dofs_.n_dofs() < 40000) {
      dealii::SparseDirectUMFPACK direct;
      direct.initialize(matrix_);
      direct.vmult(solution_, load_);
    } else {
      dealii::SolverControl control(50000, 1e-11 * load_.l2_norm());
      dealii::SolverCG<dealii::Vector<double>> cg(control);
      dealii::PreconditionSSOR<dealii::SparseMatrix<double>> preconditioner;
      preconditioner.initialize(matrix_, 1.2);
      cg.solve(matrix_, solution_, load_, preconditioner);
    }
  }

  std::vector<double> value(const Quantity& quantity, const Point& p) const {
    return values_at(quantity, quantity.on_material ? material_at(p) : motion_at(p), 3);
  }

  StateAtPoint motion_at(const Point& p) const {
    dealii::Vector<double> u(dim);
    dealii::VectorTools::point_value(dofs_, solution_, from_point(p), u);
    StateAtPoint at;
    at.displacement = {u[0], u[1], dim == 3 ? u[dim - 1] : 0.0};
    return at;
  }

  StateAtPoint material_at(const Point& p) const {
    std::vector<dealii::Tensor<1, dim>> H(dim);
    dealii::VectorTools::point_gradient(dofs_, solution_, from_point(p), H);
    StateAtPoint at;
    auto &e = at.strain, &s = at.stress;
    double trace = 0;
    for (int i = 0; i < dim; ++i) trace += H[i][i];
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j) {
        const int k = symmetric_index<3>(i, j);
        e[k] = 0.5 * (H[i][j] + H[j][i]);
        s[k] = 2 * law_.mu * e[k] + (i == j ? law_.lambda * trace : 0.0);
      }
    if (dim == 2) {
      e[2] = law_.thickness_strain({e[0], e[1], e[3]}, {s[0], s[1], s[3]}, nullptr);
      s[2] = law_.thickness_stress({}, {s[0], s[1], s[3]}, nullptr);
    }
    return at;
  }

  StaticLimit read() const {
    StaticLimit r;
    for (const Probe& probe : scene_.probes) r.probes[probe.name] = value(*probe.quantity, probe.point);
    for (const Section& section : scene_.sections) {
      auto& values = r.sections[section.name];
      for (int i = 0; i < section.count; ++i) {
        const double t = section.count > 1 ? static_cast<double>(i) / (section.count - 1) : 0.0;
        Point p;
        for (int c = 0; c < 3; ++c) p[c] = (1 - t) * section.from[c] + t * section.to[c];
        values.push_back(value(*section.quantity, p));
      }
    }
    return r;
  }

  const Scene& scene_;
  const Body& body_;
  LinearElastic law_;
  double thickness_, tolerance_ = 0;
  dealii::Triangulation<dim> triangulation_;
  dealii::FESystem<dim> fe_;
  dealii::DoFHandler<dim> dofs_;
  std::vector<dealii::Point<dim>> support_points_;
  std::vector<unsigned int> component_;
  dealii::AffineConstraints<double> constraints_;
  dealii::SparsityPattern pattern_;
  dealii::SparseMatrix<double> matrix_;
  dealii::Vector<double> load_, solution_;
};

}  // namespace

StaticLimit solve_static(const Scene& scene, const std::array<int, 3>& divisions, int degree) {
  if (scene.bodies.size() != 1)
    throw std::runtime_error(
        "the static limit wants one body, and the scene has " + std::to_string(scene.bodies.size()));
  if (!scene.bars.empty() ||
      std::any_of(scene.supports.begin(), scene.supports.end(), [](const Support& s) { return s.mean; }))
    throw std::runtime_error("the static limit knows neither bars nor supports with mode = \"mean\"");
  if (std::any_of(scene.supports.begin(), scene.supports.end(),
                  [](const Support& s) { return s.velocity != Point{}; }))
    throw std::runtime_error("the static limit is of supports at rest, and one of this scene moves");
  if (scene.large_motion)
    throw std::runtime_error(
        "the static limit is of small motion, and this scene asks for motion = \"large\"");
  if (scene.bodies[0].shape->is_round())
    throw std::runtime_error("the static limit's cells have straight sides, and this body is round");
  if (degree < 1) throw std::runtime_error("the static limit wants a polynomial degree of at least 1");
  return scene.dim() == 2 ? StaticSolver<2>(scene, divisions, degree).solve()
                          : StaticSolver<3>(scene, divisions, degree).solve();
}

}  // namespace femsph::fem
