#include "fem/mesh/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/mesh/gauss.hpp"

namespace femsph::fem {

namespace {

/// det dX/dxi at the Gauss points of a cell, m^dim.
template <int dim>
std::array<double, corners<dim>> jacobians(const Mesh& mesh, std::size_t cell) {
  double X[corners<dim> * dim];
  for (int a = 0; a < corners<dim>; ++a)
    for (int c = 0; c < dim; ++c)
      X[a * dim + c] = mesh.nodes[static_cast<std::size_t>(mesh.cell(cell)[a] * dim + c)];
  const GaussCell<double, dim> x(X);
  std::array<double, corners<dim>> r;
  Tensor<double, dim> unused;
  for (int q = 0; q < corners<dim>; ++q)
    r[static_cast<std::size_t>(q)] = cofactors<double, dim>(x.at(q), unused);
  return r;
}

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

}  // namespace

std::array<double, 8> shape_functions(int dim, const Point& xi) {
  std::array<double, 8> N{};
  for (int a = 0; a < 1 << dim; ++a) {
    double n = 1;
    for (int d = 0; d < dim; ++d) n *= 0.5 * ((a >> d) & 1 ? 1 + xi[d] : 1 - xi[d]);
    N[a] = n;
  }
  return N;
}

Point map_point(const Mesh& mesh, std::size_t cell, const Point& xi) {
  const auto N = shape_functions(mesh.dim, xi);
  Point p{};
  for (int a = 0; a < mesh.corners(); ++a)
    for (int c = 0; c < mesh.dim; ++c)
      p[c] += N[a] * mesh.nodes[static_cast<std::size_t>(mesh.cell(cell)[a] * mesh.dim + c)];
  return p;
}

Point gauss_coordinates(int dim, int q) {
  Point xi{};
  for (int d = 0; d < dim; ++d) xi[d] = (q >> d) & 1 ? gauss_point : -gauss_point;
  return xi;
}

double jacobian(const Mesh& mesh, std::size_t cell, int q) {
  return mesh.dim == 2 ? jacobians<2>(mesh, cell)[q] : jacobians<3>(mesh, cell)[q];
}

std::vector<double> lumped_mass(const Mesh& mesh, double density, double thickness) {
  std::vector<double> mass(mesh.node_count(), 0.0);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < mesh.corners(); ++q) {
      const auto N = shape_functions(mesh.dim, gauss_coordinates(mesh.dim, q));
      const double m = density * thickness * jacobian(mesh, c, q);
      for (int a = 0; a < mesh.corners(); ++a) mass[mesh.cell(c)[a]] += m * N[a];
    }
  return mass;
}

double shortest_edge(const Mesh& mesh) {
  double h = std::numeric_limits<double>::max();
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (int a = 0; a < mesh.corners(); ++a)
      for (int d = 0; d < mesh.dim; ++d)
        if (!((a >> d) & 1))
          h = std::min(h, distance(mesh.node(mesh.cell(c)[a]), mesh.node(mesh.cell(c)[a | (1 << d)])));
  return h;
}

namespace {

/// The nodes of an edge or of a bilinear face, lexicographic; an edge has -1 in the last two.
using Piece = std::array<int, 4>;

/// All cell edges (dimension 1) or faces (dimension 2) whose nodes are all marked, once each. `boundary_only`
/// leaves out those that two cells share, which are not on the boundary.
std::vector<Piece> marked_pieces(const Mesh& mesh, const std::vector<char>& marked, int dimension,
                                 bool boundary_only) {
  std::vector<std::pair<Piece, Piece>> found;  // sorted nodes, nodes
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (int first = 0; first < mesh.corners(); ++first)
      for (int directions = 1; directions < mesh.corners(); ++directions) {
        if (__builtin_popcount(static_cast<unsigned>(directions)) != dimension || (first & directions))
          continue;
        Piece nodes{-1, -1, -1, -1};
        int n = 0;
        bool all = true;
        for (int a = 0; a < mesh.corners(); ++a)
          if ((a & ~directions) == first) {
            nodes[n++] = mesh.cell(c)[a];
            all = all && marked[mesh.cell(c)[a]];
          }
        if (!all) continue;
        Piece key = nodes;
        std::sort(key.begin(), key.end());
        found.emplace_back(key, nodes);
      }
  std::sort(found.begin(), found.end());
  std::vector<Piece> pieces;
  for (std::size_t i = 0, j; i < found.size(); i = j) {
    for (j = i + 1; j < found.size() && found[j].first == found[i].first; ++j) {
    }
    if (j == i + 1 || !boundary_only) pieces.push_back(found[i].second);
  }
  return pieces;
}

/// The integral of each node's shape function over the piece, m or m^2.
std::array<double, 4> piece_shares(const Mesh& mesh, const Piece& piece) {
  std::array<double, 4> share{};
  if (piece[2] < 0) {
    share[0] = share[1] = 0.5 * distance(mesh.node(piece[0]), mesh.node(piece[1]));
    return share;
  }
  for (int q = 0; q < 4; ++q) {
    const Point xi = gauss_coordinates(2, q);
    Point a{}, b{}, normal;
    for (int n = 0; n < 4; ++n) {
      const Point p = mesh.node(piece[n]);
      const double x = n & 1 ? 0.5 : -0.5, y = n & 2 ? 0.5 : -0.5;
      for (int c = 0; c < 3; ++c) {
        a[c] += p[c] * x * (0.5 + y * xi[1]);
        b[c] += p[c] * y * (0.5 + x * xi[0]);
      }
    }
    cross(a.data(), b.data(), normal.data());
    const auto N = shape_functions(2, xi);
    for (int n = 0; n < 4; ++n) share[n] += N[n] * std::hypot(normal[0], normal[1], normal[2]);
  }
  return share;
}

/// The weights of the points with a positive share, scaled to the sum 1.
std::vector<Weight> normalised(const std::vector<double>& share) {
  double total = 0;
  for (const double s : share) total += s;
  std::vector<Weight> r;
  for (std::size_t i = 0; i < share.size(); ++i)
    if (share[i] > 0) r.push_back({i, share[i] / total});
  return r;
}

}  // namespace

std::vector<Weight> place_weights(const Mesh& mesh, const Shape& shape, const Place& place,
                                  std::span<const double> mass, double tolerance) {
  if (place.point) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < mesh.node_count(); ++i)
      if (distance(mesh.node(i), *place.point) < distance(mesh.node(nearest), *place.point)) nearest = i;
    return {{nearest, 1.0}};
  }
  const auto within = [&](std::size_t i) {
    return !place.within || place.within->contains(mesh.node(i), tolerance);
  };
  if (place.sides.empty()) {
    std::vector<double> share(mass.begin(), mass.end());
    for (std::size_t i = 0; i < share.size(); ++i)
      if (!within(i)) share[i] = 0;
    return normalised(share);
  }

  std::vector<char> marked(mesh.node_count());
  for (std::size_t i = 0; i < mesh.node_count(); ++i)
    marked[i] = within(i) &&
                std::all_of(place.sides.begin(), place.sides.end(), [&](const std::string& side) {
                  return shape.on_side(side, mesh.node(i), tolerance);
                });
  const int dimension = mesh.dim - static_cast<int>(place.sides.size());
  std::vector<double> share(mesh.node_count(), 0.0);
  bool any = false;
  if (dimension > 0)
    for (const Piece& piece : marked_pieces(mesh, marked, dimension, dimension == mesh.dim - 1)) {
      const auto s = piece_shares(mesh, piece);
      for (int n = 0; n < 4 && piece[n] >= 0; ++n) share[piece[n]] += s[n];
      any = true;
    }
  if (!any) share.assign(marked.begin(), marked.end());
  return normalised(share);
}

}  // namespace femsph::fem
