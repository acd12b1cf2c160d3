#pragma once
// Stress and strain of cells: means of their material points, weighted by volume.

#include <array>
#include <cmath>
#include <vector>

#include "model/motion/bodies/discretization.hpp"

namespace femsph {

/// Where the nine components xx xy xz yx yy yz zx zy zz stand in xx yy zz xy yz zx.
inline constexpr std::array<int, 9> six_of_nine{0, 3, 5, 3, 1, 4, 5, 4, 2};

/// a b + c, with one rounding where the processor supports it. Explicit, because the compiler might use it or
/// not depending on the surrounding loop, which would change the last bits.
inline double multiply_add(double a, double b, double c) {
#ifdef __FMA__
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}

struct CellFields {
  std::vector<double> stress, strain;  ///< nine components a cell
  std::vector<double> equivalent;      ///< mean von Mises stress of the points
  std::vector<double> principal;       ///< three a cell, of the mean stress, the largest first
  std::vector<double> plastic;         ///< empty when the law has none
  MaterialState flow;                  ///< means of the limits of stress; only for recovered fields
};

/// The share of each material point in the undeformed volume of its cell; empty if cells have one point.
std::vector<double> volume_shares(const Discretization& d, std::size_t cells);

/// Works on some thousand cells at a time, so that the states of their points stay in the caches, but in at
/// most eight parts, since a discretization may do the same preparation (mirrored particles) in every call.
class CellMeans {
 public:
  void fill(const Discretization& d, const double* u, const std::vector<double>& share, std::size_t cells,
            bool with_flow, CellFields& out);

 private:
  void mean(std::size_t e, std::size_t cell, std::size_t k, const double* shares, CellFields& out) const;

  MaterialState state_;
  std::vector<std::size_t> points_;
};

}  // namespace femsph
