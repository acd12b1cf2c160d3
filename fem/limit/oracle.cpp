// A reference for the tests: the fully integrated element computed by deal.II's FEValues, one cell at a time.
// It shares the mesh with the fast loop, but no code of the force.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <stdexcept>

#include "fem/elements/full.hpp"
#include "fem/explicit_fem.hpp"
#include "fem/limit/limit.hpp"
#include "fem/limit/triangulation.hpp"

namespace femsph::fem {

namespace {

template <int dim>
class Oracle final : public ExplicitFem {
 public:
  Oracle(const Scene& scene, std::size_t body, const Options& options)
      : ExplicitFem(scene, body, options),
        law_(elastic_of(scene, body, "the FEValues reference")),
        fe_(dealii::FE_Q<dim>(1), dim),
        dofs_(triangulation_) {
    make_triangulation<dim>(*shape_, options.divisions, options.distortion, triangulation_);
    node_.resize(triangulation_.n_vertices());
    for (std::size_t i = 0; i < mesh_.vertex.size(); ++i) node_[mesh_.vertex[i]] = i;
    dofs_.distribute_dofs(fe_);
  }

  std::string describe() const override { return ExplicitFem::describe() + " by deal.II FEValues"; }
  void internal_force(const double* u, const double*, double, double* f, double*) override {
    apply(u, f, -1);
  }
  void stiffness(const double* x, double* y) const override { apply(x, y, 1); }
  Energies energies(const double* u) const override {
    std::vector<double> y(layout().size);
    apply(u, y.data(), 1);
    double e = 0;
    for (std::size_t i = 0; i < y.size(); ++i) e += 0.5 * u[i] * y[i];
    return {e};
  }

 private:
  /// y_i = factor times the sum over cells of the integral of sigma(u) : grad phi_i.
  void apply(const double* u, double* y, double factor) const {
    std::fill(y, y + layout().size, 0.0);
    dealii::FEValues<dim> values(
        fe_, dealii::QGauss<dim>(2), dealii::update_gradients | dealii::update_JxW_values);
    const dealii::FEValuesExtractors::Vector displacement(0);
    std::vector<double> local(fe_.n_dofs_per_cell());
    std::vector<dealii::SymmetricTensor<2, dim>> strains(values.n_quadrature_points);
    for (const auto& cell : dofs_.active_cell_iterators()) {
      values.reinit(cell);
      const auto slot = [&](unsigned int i) {
        const auto [component, vertex] = fe_.system_to_component_index(i);
        return layout().at(node_[cell->vertex_index(vertex)], static_cast<int>(component));
      };
      for (unsigned int i = 0; i < local.size(); ++i) local[i] = u[slot(i)];
      values[displacement].get_function_symmetric_gradients_from_local_dof_values(local, strains);
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q) {
        const dealii::SymmetricTensor<2, dim> stress =
            law_.lambda * dealii::trace(strains[q]) * dealii::unit_symmetric_tensor<dim>() +
            2 * law_.mu * strains[q];
        for (unsigned int i = 0; i < local.size(); ++i)
          y[slot(i)] += factor * thickness_ * (stress * values[displacement].symmetric_gradient(i, q)) *
                        values.JxW(q);
      }
    }
  }

  LinearElastic law_;
  std::vector<std::size_t> node_;  ///< our node of each vertex of deal.II
  dealii::Triangulation<dim> triangulation_;
  dealii::FESystem<dim> fe_;
  dealii::DoFHandler<dim> dofs_;
};

}  // namespace

std::unique_ptr<Discretization> make_oracle(const Scene& scene, std::size_t body, const Options& options) {
  const std::string element = FullElement::entry.word;
  if (options.element != element || scene.large_motion || !scene.bars.empty())
    throw std::runtime_error("the FEValues reference takes the element \"" + element +
                             "\" only, in small strain and without bars");
  if (scene.dim() == 2) return std::make_unique<Oracle<2>>(scene, body, options);
  return std::make_unique<Oracle<3>>(scene, body, options);
}

}  // namespace femsph::fem
