#pragma once
// A body filled with particles. On a lattice, which starts on the surface of the body, they are numbered
// along x first, so that neighbours are near in memory; jittered particles are numbered by slabs
// (number_by_slabs).

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "sph/options.hpp"

namespace femsph::sph {

/// The particles on a regular grid: `at` holds the particle at each place of the grid, -1 outside of the
/// body.
struct Lattice {
  std::array<int, 3> count{1, 1, 1};
  Point spacing{};  ///< m, per axis
  Point origin{};   ///< of place (0, 0, 0), m
  std::vector<int> at;
  std::vector<std::array<int, 3>> place;  ///< of each particle
  /// Index of a place in `at`.
  std::size_t slot(int i, int j, int k) const {
    return std::size_t(i) + std::size_t(count[0]) * (std::size_t(j) + std::size_t(count[1]) * std::size_t(k));
  }
  int particle(int i, int j, int k) const {
    if (i < 0 || j < 0 || k < 0 || i >= count[0] || j >= count[1] || k >= count[2]) return -1;
    return at[slot(i, j, k)];
  }
};

/// The image of particle `of` beyond a symmetry plane: components of its vectors are those of `of` times
/// `sign`.
struct Mirrored {
  std::size_t of;
  std::array<double, 3> sign;
};

/// The symmetry plane x_axis = at.
struct MirrorPlane {
  int axis;
  double at;
  bool upper;  ///< the plane is the upper side of the body, else the lower one
  bool holds(const Point& x, double tolerance) const {
    return std::abs(x[std::size_t(axis)] - at) < tolerance;
  }
};
std::vector<MirrorPlane> mirror_planes(const Scene& scene, std::size_t body);
/// The part of a particle's volume that belongs to the body and not to its image: 1/2 on a symmetry plane,
/// 1/4 on two, else 1.
double part_of(const Point& x, double spacing, const std::vector<MirrorPlane>& planes);

struct Particles {
  int dim = 2;
  double spacing = 0;           ///< d, the smallest over the axes, m
  double cell = 0;              ///< d^dim, m^dim
  std::vector<Point> position;  ///< m; the body's own particles, then the mirrored ones
  /// V_i by the mass rule, m^dim (an area in 2D, without the thickness).
  std::vector<double> volume;
  /// f_i, the part of the full (solid) angle around the particle that the body and its images fill: 1 inside,
  /// 1/2 on a face, 1/4 on an edge.
  std::vector<double> fraction;
  /// K_i, the volume that the particle has as a neighbour in kernel sums, m^dim: V_i, or V_i / f_i
  /// (set_kernel_volumes).
  std::vector<double> kernel_volume;
  std::vector<double> part;         ///< part_of() each particle
  std::vector<Mirrored> mirrored;   ///< the last of `position`
  std::vector<MirrorPlane> planes;  ///< the planes of `mirrored`
  Lattice lattice;
  /// Fitted particles, which have no lattice: cells whose corners, in lexicographic order, are the particles.
  std::vector<std::array<int, 8>> cells;
  std::string note;  ///< a warning about the filling; empty: none
  /// The particles are on the lattice; false for jittered and for fitted particles.
  bool regular = true;

  std::size_t size() const { return position.size() - mirrored.size(); }  ///< without the mirrored ones
  double own_volume(std::size_t i) const { return volume[i] * part[i]; }
  /// The particle itself, or the one that it mirrors.
  std::size_t own(std::size_t i) const { return i < size() ? i : mirrored[i - size()].of; }
  /// Component a of a vector at particle i is that of own(i) times this.
  double sign(std::size_t i, int a) const {
    return i < size() ? 1.0 : mirrored[i - size()].sign[std::size_t(a)];
  }
  bool on_plane(const Point& x, const MirrorPlane& plane) const { return plane.holds(x, 1e-6 * spacing); }
  /// v without its components normal to the symmetry planes that particle i lies on.
  Point along_planes(std::size_t i, Point v) const {
    for (const MirrorPlane& m : planes)
      if (on_plane(position[i], m)) v[std::size_t(m.axis)] = 0;
    return v;
  }
};

/// Fills a body on a lattice. The spacing is adjusted along each axis so that particles are on both ends of
/// the bounding box. Volumes are those in the body and its mirror images. Throws Refusal if the spacing does
/// not fit the body.
Particles fill(const Shape& shape, const Options& options, const std::vector<MirrorPlane>& planes = {});

/// Fills a shape that has cells or can be cut into cells (meshes, rings, cylinders, ..): the particles are
/// the corners of these cells, cut to the spacing, so particles on a side lie on it. Volumes are the
/// integrals of the cells' shape functions (`trapezoid`), or as in fill(). Empty if the cells do not suit the
/// spacing; `why` then says why.
std::optional<Particles> fill_fitted(const Shape& shape, const Options& options,
                                     const std::vector<MirrorPlane>& planes, std::string& why);
/// Whether fill_fitted() applies: the shape has cells or can be cut into cells, and the options do not choose
/// the lattice.
bool is_fitted(const Shape& shape, const Options& options);
/// fill_fitted() where it applies and succeeds, else fill(); `note` then says why it did not succeed.
Particles fill_best(const Shape& shape, const Options& options, const std::vector<MirrorPlane>& planes = {});

/// The cells of a body cut into pieces of about `spacing`. The pieces fit together: opposite edges of a cell
/// have the same number of pieces, and so from cell to cell. Empty if an edge of a piece would be too short
/// or too long for one smoothing length; `why` then says so.
std::optional<CellMesh> cut_to_spacing(const CellMesh& mesh, double spacing, std::string& why);

/// Sets K_i. With whole cells, K_i = V_i / f_i, and trapezoid volumes, kernel sums satisfy summation by
/// parts: the derivative in the first layer below a surface is central, and a uniform stress is in balance
/// with a traction on the surface particles alone.
void set_kernel_volumes(Particles& particles, KernelVolume kind);

/// Adds the mirror images of the particles within `radius` of each plane, corners of two planes included.
/// Throws Refusal if two opposite planes are nearer than that.
void add_mirrored(Particles& particles, const std::vector<MirrorPlane>& planes, double radius);

}  // namespace femsph::sph
