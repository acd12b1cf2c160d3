// Checks of deformed cells: which one has turned inside out (det dx/dxi <= 0 at a Gauss point), and which one
// has become stiffest.

#include <cstdio>
#include <limits>

#include "fem/elements/gather.hpp"
#include "fem/explicit_fem.hpp"
#include "fem/mesh/gauss.hpp"
#include "model/material/stiffening.hpp"
#include "model/numerics/parallel.hpp"

namespace femsph::fem {

namespace {

/// The corners of eight cells: undeformed positions X, current positions x, m.
template <int dim>
struct Corners {
  static constexpr int size = dim * corners<dim>;
  Pack X[size], x[size];
  Corners(const Mesh& mesh, const Batches& batches, std::size_t batch, const double* u) {
    const int* at = &batches.gather[batch * corners<dim> * lanes];
    gather<dim>(mesh.nodes.data(), at, 0, X);
    gather<dim>(u, at, 0, x);
    for (int k = 0; k < size; ++k) x[k] += X[k];
  }
};

/// The first cell that has the largest value. NaN counts as infinite.
struct Largest {
  double value = -std::numeric_limits<double>::infinity();
  std::size_t cell = 0;
  void take(const Pack& values, std::size_t batch) {
    for (int l = 0; l < lanes; ++l)
      if (!(values[l] <= value))
        value = values[l] == values[l] ? values[l] : std::numeric_limits<double>::infinity(),
        cell = batch * lanes + std::size_t(l);
  }
};

/// The largest of all cells; largest_of(begin, end) gives that of a range of batches.
template <class LargestOf>
Largest largest_cell(const Batches& batches, LargestOf&& largest_of) {
  std::vector<Largest> of_domain((batches.count + batches_per_domain - 1) / batches_per_domain);
  parallel_for(
      batches.count, batches_per_domain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; b += batches_per_domain)
          of_domain[b / batches_per_domain] = largest_of(b, std::min(b + batches_per_domain, end));
      },
      lanes);
  Largest all;
  for (const Largest& l : of_domain)
    if (l.value > all.value) all = l;
  return all;
}

/// The largest loss of volume at a Gauss point, 1 - det(dx/dxi) / det(dX/dxi). From 1 on the cell is inside
/// out there.
template <int dim>
Largest most_shrunk_cell(const Mesh& mesh, const Batches& batches, const double* u) {
  return largest_cell(batches, [&](std::size_t begin, std::size_t end) {
    Largest worst;
    for (std::size_t b = begin; b < end; ++b) {
      const Corners<dim> at(mesh, batches, b, u);
      const GaussCell<Pack, dim> before(at.X), now(at.x);
      for (int q = 0; q < corners<dim>; ++q) {
        Tensor<Pack, dim> unused;
        const Pack was = cofactors<Pack, dim>(before.at(q), unused);
        worst.take(1.0 - cofactors<Pack, dim>(now.at(q), unused) / was, b);
      }
    }
    return worst;
  });
}

/// The cell that has stiffened most (model/material/stiffening.hpp), at the Gauss points or at the centre,
/// wherever the element has its material points.
template <int dim, class LawType>
Largest stiffest_cell(const Mesh& mesh, const Batches& batches, const double* u, bool at_centre,
                      const LawType& law) {
  return largest_cell(batches, [&](std::size_t begin, std::size_t end) {
    Largest worst;
    for (std::size_t b = begin; b < end; ++b) {
      const Corners<dim> at(mesh, batches, b, u);
      const auto ratio = [&](const Tensor<Pack, dim>& before, const Tensor<Pack, dim>& now) {
        Tensor<Pack, dim> C, unused, inverse;
        const Pack volume = cofactors<Pack, dim>(now, C), r = 1.0 / volume;
        for (int c = 0; c < dim; ++c)
          for (int i = 0; i < dim; ++i) {
            Pack s = before[0][c] * C[0][i];  // dX_c / dxi_d  dxi_d / dx_i
            for (int d = 1; d < dim; ++d) s += before[d][c] * C[d][i];
            inverse[c][i] = s * r;
          }
        return stiffening<Pack, dim>(law, inverse, volume / cofactors<Pack, dim>(before, unused));
      };
      if (at_centre) {
        worst.take(ratio(centre_derivatives<Pack, dim>(at.X), centre_derivatives<Pack, dim>(at.x)), b);
        continue;
      }
      const GaussCell<Pack, dim> before(at.X), now(at.x);
      Pack most{};
      for (int q = 0; q < corners<dim>; ++q) {
        const Pack r = ratio(before.at(q), now.at(q));
        most = select(r <= most, most, r);  // NaN stays
      }
      worst.take(most, b);
    }
    return worst;
  });
}

}  // namespace

/// The cell that a lane holds: the lanes beyond the last cell repeat it.
std::size_t ExplicitFem::cell_of(std::size_t lane) const { return std::min(lane, mesh_.cell_count() - 1); }

Point ExplicitFem::centre_now(std::size_t cell, const double* u) const {
  Point x{};
  for (int a = 0; a < mesh_.corners(); ++a) {
    const std::size_t node = static_cast<std::size_t>(mesh_.cell(cell)[a]);
    for (int c = 0; c < mesh_.dim; ++c)
      x[c] += (mesh_.node(node)[c] + u[layout_.at(node, c)]) / mesh_.corners();
  }
  return x;
}

std::optional<Trouble> ExplicitFem::trouble(const double* u) const {
  const Largest worst = mesh_.dim == 2 ? most_shrunk_cell<2>(mesh_, batches_, u)
                                       : most_shrunk_cell<3>(mesh_, batches_, u);
  if (worst.value < 1) return std::nullopt;
  const std::size_t cell = cell_of(worst.cell);
  char share[32];
  std::snprintf(share, sizeof share, "%.3g", 1 - worst.value);
  return Trouble{mesh_.cell_name(cell) + " has turned inside out: at one of its points the volume is " +
                     share + " times what it was",
                 "the mesh is crushed or tangled there, more than its cells can follow: try other divisions "
                 "there, a gentler load, or a method of SPH",
                 centre_now(cell, u)};
}

std::optional<Stiffening> ExplicitFem::stiffening(const double* u) const {
  return std::visit(
      [&]<class LawType>(const LawType& law) -> std::optional<Stiffening> {
        if constexpr (!Stiffens<LawType>)
          return std::nullopt;
        else {
          const bool centre = loop_->points_per_cell() == 1;
          const Largest most = mesh_.dim == 2 ? stiffest_cell<2>(mesh_, batches_, u, centre, law)
                                              : stiffest_cell<3>(mesh_, batches_, u, centre, law);
          const std::size_t cell = cell_of(most.cell);
          return Stiffening{most.value, mesh_.cell_name(cell), centre_now(cell, u)};
        }
      },
      law_);
}

}  // namespace femsph::fem
