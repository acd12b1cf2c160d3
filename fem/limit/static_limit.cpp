// The static limit: a solution of static linear elasticity with elements of high degree, to which FEM and SPH
// must both converge.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
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
#include <array>
#include <optional>
#include <stdexcept>

#include "fem/limit/limit.hpp"
#include "fem/limit/places.hpp"
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
    dofs_.distribute_dofs(fe_);
    places_.emplace(*body_.shape, dofs_);
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
  void constrain() {
    for (const Support& support : scene_.holds())
      for (const auto i : places_->dofs_of(support.place))
        if (support.fixed[places_->component(i)]) constraints_.add_line(i);
    constraints_.close();
  }

  void add_load(const Load& load, dealii::Vector<double>& force) const {
    if (load.pressure != 0)
      throw std::runtime_error("the converged static limit takes forces, not a pressure");
    const std::vector<double> weight = places_->weights_of(load.place);
    std::array<double, dim> total{};
    for (std::size_t i = 0; i < weight.size(); ++i) total[places_->component(i)] += weight[i];
    if (!(total[0] > 0)) throw std::runtime_error("a load acts on no point of the mesh of the static limit");
    for (std::size_t i = 0; i < weight.size(); ++i) {
      const unsigned int c = places_->component(i);
      force[i] += load.force[c] * load.history.factor.back() * weight[i] / total[c];
    }
  }

  /// The stiffness matrix of a cell is one product, K = strain^T stress. Both factors have one row for each
  /// strain component at each quadrature point. Degree 3 in 3D has 192 unknowns and 64 points per cell: large
  /// enough for BLAS to be faster.
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

  /// A direct solver in 2D and for small 3D bodies; conjugate gradients for larger ones, whose factorized
  /// matrix would need too much memory.
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
    dealii::VectorTools::point_value(dofs_, solution_, to_dealii<dim>(p), u);
    StateAtPoint at;
    at.displacement = {u[0], u[1], dim == 3 ? u[dim - 1] : 0.0};
    return at;
  }

  StateAtPoint material_at(const Point& p) const {
    std::vector<dealii::Tensor<1, dim>> H(dim);
    dealii::VectorTools::point_gradient(dofs_, solution_, to_dealii<dim>(p), H);
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
  double thickness_;  ///< m; 1 in 3D
  dealii::Triangulation<dim> triangulation_;
  dealii::FESystem<dim> fe_;
  dealii::DoFHandler<dim> dofs_;
  std::optional<Places<dim>> places_;
  dealii::AffineConstraints<double> constraints_;
  dealii::SparsityPattern pattern_;
  dealii::SparseMatrix<double> matrix_;
  dealii::Vector<double> load_, solution_;
};

}  // namespace

StaticLimit solve_static(const Scene& scene, const std::array<int, 3>& divisions, int degree) {
  if (scene.bodies.size() != 1)
    throw std::runtime_error(
        "the static limit takes one body, and the scene has " + std::to_string(scene.bodies.size()));
  if (!scene.bars.empty() ||
      std::any_of(scene.supports.begin(), scene.supports.end(), [](const Support& s) { return s.mean; }))
    throw std::runtime_error("the static limit takes neither bars nor supports with mode = \"mean\"");
  if (std::any_of(scene.supports.begin(), scene.supports.end(),
                  [](const Support& s) { return s.velocity != Point{}; }))
    throw std::runtime_error("the static limit takes supports at rest, and one of this scene moves");
  if (scene.large_motion)
    throw std::runtime_error("the static limit is for small motion, and this scene has motion = \"large\"");
  if (scene.bodies[0].shape->is_round())
    throw std::runtime_error("the static limit's cells have straight sides, and this body is round");
  if (degree < 1) throw std::runtime_error("the static limit needs a polynomial degree of at least 1");
  return scene.dim() == 2 ? StaticSolver<2>(scene, divisions, degree).solve()
                          : StaticSolver<3>(scene, divisions, degree).solve();
}

}  // namespace femsph::fem
