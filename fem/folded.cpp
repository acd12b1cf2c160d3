// Cells that have turned inside out: det dx/dxi at the Gauss points of the deformed cell.

#include <cstdio>
#include <limits>

#include "fem/explicit_fem.hpp"
#include "fem/gather.hpp"
#include "fem/gauss.hpp"
#include "fem/geometry.hpp"
#include "model/numerics/parallel.hpp"

namespace femsph::fem {

namespace {

struct Worst {
  double share = std::numeric_limits<double>::infinity();  ///< of the volume at a point, now over undeformed
  std::size_t cell = 0;
};

/// The cell with the least share, the first of these; one that is no number counts as less than any.
template <int dim>
Worst worst_cell(const Mesh& mesh, const Batches& batches, const double* u) {
  constexpr int size = dim * corners<dim>;
  std::vector<Worst> of_domain((batches.count + batches_per_domain - 1) / batches_per_domain);
  parallel_for(batches.count, batches_per_domain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      Worst& worst = of_domain[b / batches_per_domain];
      const int* at = &batches.gather[b * corners<dim> * lanes];
      Pack X[size], x[size];
      gather<dim>(mesh.nodes.data(), at, 0, X);
      gather<dim>(u, at, 0, x);
      for (int k = 0; k < size; ++k) x[k] += X[k];
      const GaussCell<Pack, dim> before(X), now(x);
      for (int q = 0; q < corners<dim>; ++q) {
        Tensor<Pack, dim> unused;
        const Pack was = cofactors<Pack, dim>(before.at(q), unused), share = cofactors<Pack, dim>(now.at(q), unused) / was;
        for (int l = 0; l < lanes; ++l)
          if (!(share[l] >= worst.share)) worst = {share[l] == share[l] ? share[l] : -std::numeric_limits<double>::infinity(), b * lanes + std::size_t(l)};
      }
    }
  }, lanes);
  Worst worst;
  for (const Worst& w : of_domain)
    if (w.share < worst.share) worst = w;
  return worst;
}

}  // namespace

std::optional<Trouble> ExplicitFem::trouble(const double* u) const {
  const Worst worst = mesh_.dim == 2 ? worst_cell<2>(mesh_, batches_, u) : worst_cell<3>(mesh_, batches_, u);
  if (worst.share > 0) return std::nullopt;
  const std::size_t cell = std::min(worst.cell, mesh_.cell_count() - 1);  // lanes beyond the last cell repeat it
  Point x{};
  for (int a = 0; a < mesh_.corners(); ++a) {
    const std::size_t node = static_cast<std::size_t>(mesh_.cell(cell)[a]);
    for (int c = 0; c < mesh_.dim; ++c) x[c] += (mesh_.node(node)[c] + u[layout_.at(node, c)]) / mesh_.corners();
  }
  char share[32];
  std::snprintf(share, sizeof share, "%.3g", worst.share);
  return Trouble{"cell " + std::to_string(cell) + " has turned inside out: at one of its points the volume is " + share + " times what it was",
                 "the mesh is crushed or tangled there, more than its cells can follow: try other divisions there, a gentler load, or a method of SPH", x};
}

}  // namespace femsph::fem
