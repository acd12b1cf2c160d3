#pragma once
// A body filled with particles: a lattice that starts on the body's surface, rows along x first, so that neighbours are near in memory.

#include <array>
#include <vector>

#include "model/scene/scene.hpp"
#include "sph/sph.hpp"

namespace femsph::sph {

/// Where the particles sit in a regular grid: `at` holds the particle of each grid place, -1 where the body is not.
struct Lattice {
  std::array<int, 3> count{1, 1, 1};
  Point spacing{};  ///< m, per axis
  Point origin{};
  std::vector<int> at;
  std::vector<std::array<int, 3>> place;  ///< of each particle
  int particle(int i, int j, int k) const {
    if (i < 0 || j < 0 || k < 0 || i >= count[0] || j >= count[1] || k >= count[2]) return -1;
    return at[std::size_t(i) + std::size_t(count[0]) * (std::size_t(j) + std::size_t(count[1]) * k)];
  }
};

struct Particles {
  int dim = 2;
  double spacing = 0;               ///< d, the smallest over the axes, m
  double cell = 0;                  ///< d^dim, m^dim
  std::vector<Point> position;      ///< m
  std::vector<double> volume;       ///< V_i by the mass rule, m^dim (an area in 2D, without the thickness)
  Lattice lattice;
  bool regular = true;              ///< false once jittered: the lattice then only says which particles are where
  std::size_t size() const { return position.size(); }
};

/// The spacing is adjusted per axis so that particles sit on both ends of the body's bounding box.
/// Throws std::runtime_error when the spacing does not fit the body.
Particles fill(const Shape& shape, const Options& options);

}  // namespace femsph::sph
