#pragma once
// Places of a scene on a deal.II mesh of any degree: which degrees of freedom belong to a place, and how a
// load on it is shared among them.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <vector>

#include "fem/limit/points.hpp"
#include "model/scene/scene.hpp"

namespace femsph::fem {

template <int dim>
class Places {
 public:
  using Index = dealii::types::global_dof_index;

  /// Of a body's shape; the degrees of freedom must have been distributed, and both must outlive this.
  Places(const Shape& shape, const dealii::DoFHandler<dim>& dofs)
      : shape_(shape),
        dofs_(dofs),
        fe_(dofs.get_fe()),
        tolerance_(1e-6 * dealii::GridTools::minimal_cell_diameter(dofs.get_triangulation())) {
    support_points_.resize(dofs_.n_dofs());
    dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<dim>(), dofs_, support_points_);
    component_.resize(dofs_.n_dofs());
    std::vector<Index> global(fe_.n_dofs_per_cell());
    for (const auto& cell : dofs_.active_cell_iterators()) {
      cell->get_dof_indices(global);
      for (unsigned int i = 0; i < global.size(); ++i)
        component_[global[i]] = fe_.system_to_component_index(i).first;
    }
  }

  /// Which displacement a degree of freedom is: 0 along x, 1 along y, 2 along z.
  unsigned int component(Index i) const { return component_[i]; }

  /// The degrees of freedom of a place, of all components: those whose support points lie on it, or those of
  /// the support point nearest to its point.
  std::vector<Index> dofs_of(const Place& place) const {
    if (place.point) return nearest(*place.point);
    std::vector<Index> r;
    for (Index i = 0; i < support_points_.size(); ++i)
      if (on(place, support_points_[i])) r.push_back(i);
    return r;
  }

  /// Weights by which a force on a place is shared: shape functions integrated over the faces, edges or
  /// vertices on it, or over the body. Not normalised.
  std::vector<double> weights_of(const Place& place) const {
    std::vector<double> share(dofs_.n_dofs(), 0.0);
    const int dimension = dim - static_cast<int>(place.sides.size());
    if (!place.point && place.sides.empty())
      over_body(share);
    else if (!place.point && dimension == dim - 1)
      over_faces(place, share);
    else if (!place.point && dim == 3 && dimension == 1)
      over_lines(place, share);
    else
      for (const Index i : dofs_of(place)) share[i] = 1;
    return share;
  }

 private:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  bool on(const Place& place, const dealii::Point<dim>& p) const {
    if (place.within && !place.within->contains(to_point<dim>(p), tolerance_)) return false;
    return std::all_of(place.sides.begin(), place.sides.end(), [&](const std::string& side) {
      return shape_.on_side(side, to_point<dim>(p), tolerance_);
    });
  }

  /// Degrees of freedom of the support point nearest to p.
  std::vector<Index> nearest(const Point& p) const {
    double best = std::numeric_limits<double>::max();
    std::vector<Index> r;
    for (Index i = 0; i < support_points_.size(); ++i) {
      const double d = support_points_[i].distance(to_dealii<dim>(p));
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

  /// Adds weight times the shape functions of a cell at a reference point: one quadrature point of a load.
  void add_point(const Cell& cell, const dealii::Point<dim>& xi, double weight,
                 std::vector<double>& share) const {
    std::vector<Index> global(fe_.n_dofs_per_cell());
    cell->get_dof_indices(global);
    for (unsigned int i = 0; i < global.size(); ++i) share[global[i]] += weight * fe_.shape_value(i, xi);
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

  const Shape& shape_;
  const dealii::DoFHandler<dim>& dofs_;
  const dealii::FiniteElement<dim>& fe_;
  double tolerance_;  ///< m
  std::vector<dealii::Point<dim>> support_points_;
  std::vector<unsigned int> component_;
};

}  // namespace femsph::fem
