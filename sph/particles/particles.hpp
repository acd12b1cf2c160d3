#pragma once
// A body filled with particles: a lattice that starts on the body's surface, rows along x first, so that
// neighbours are near in memory; jittered: in slabs (number_by_slabs).

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "sph/options.hpp"

namespace femsph::sph {

/// Where the particles sit in a regular grid: `at` holds the particle of each grid place, -1 where the body
/// is not.
struct Lattice {
  std::array<int, 3> count{1, 1, 1};
  Point spacing{};  ///< m, per axis
  Point origin{};
  std::vector<int> at;
  std::vector<std::array<int, 3>> place;  ///< of each particle
  /// Of a grid place, in `at`.
  std::size_t slot(int i, int j, int k) const {
    return std::size_t(i) + std::size_t(count[0]) * (std::size_t(j) + std::size_t(count[1]) * std::size_t(k));
  }
  int particle(int i, int j, int k) const {
    if (i < 0 || j < 0 || k < 0 || i >= count[0] || j >= count[1] || k >= count[2]) return -1;
    return at[slot(i, j, k)];
  }
};

/// A particle beyond a symmetry plane: particle `of` of the body, with the components of vectors times
/// `sign`.
struct Mirrored {
  std::size_t of;
  std::array<double, 3> sign;
};

/// A symmetry plane: x_axis = at, the body on its lower (or upper) side.
struct MirrorPlane {
  int axis;
  double at;
  bool upper;  ///< the plane is the body's upper side
  bool holds(const Point& x, double tolerance) const {
    return std::abs(x[std::size_t(axis)] - at) < tolerance;
  }
};
std::vector<MirrorPlane> mirror_planes(const Scene& scene, std::size_t body);
/// Of a particle's volume, what belongs to the body: 1/2 on a symmetry plane, 1/4 on two, else 1.
double part_of(const Point& x, double spacing, const std::vector<MirrorPlane>& planes);

struct Particles {
  int dim = 2;
  double spacing = 0;           ///< d, the smallest over the axes, m
  double cell = 0;              ///< d^dim, m^dim
  std::vector<Point> position;  ///< m; the body's own particles, then the mirrored ones
  /// V_i by the mass rule, m^dim (an area in 2D, without the thickness).
  std::vector<double> volume;
  /// f_i, share of the full angle that the body (with its images) fills there: 1 inside, 1/2 on a face, 1/4
  /// on an edge.
  std::vector<double> fraction;
  /// K_i, of a neighbour in kernel sums, m^dim: V_i, or V_i / f_i (set_kernel_volumes).
  std::vector<double> kernel_volume;
  std::vector<double> part;         ///< part_of() each particle
  std::vector<Mirrored> mirrored;   ///< the last of `position`
  std::vector<MirrorPlane> planes;  ///< that these are mirrored in
  Lattice lattice;
  /// Of a fitted body in place of the lattice: the particles are the cells' corners, in lexicographic order.
  std::vector<std::array<int, 8>> cells;
  std::string note;  ///< what the user should know of the filling; empty: nothing
  /// False once jittered, when the lattice only says which particles are where, and in a fitted body.
  bool regular = true;

  std::size_t size() const { return position.size() - mirrored.size(); }  ///< of the body's own
  double own_volume(std::size_t i) const { return volume[i] * part[i]; }
  /// The particle itself, or the one that it mirrors.
  std::size_t own(std::size_t i) const { return i < size() ? i : mirrored[i - size()].of; }
  /// Of component a of a vector at particle i, if that of own(i) is known.
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

/// The spacing is adjusted per axis so that particles sit on both ends of the body's bounding box.
/// Throws std::runtime_error when the spacing does not fit the body.
/// Volumes are those in the body with its mirror images: beyond a symmetry plane it goes on.
Particles fill(const Shape& shape, const Options& options, const std::vector<MirrorPlane>& planes = {});

/// The particles of a shape that has cells, or cuts itself into some (meshes, rings, cylinders, ..), are the
/// corners of these, cut to the spacing: those on a side lie on it. Volumes are what the cells' shape
/// functions integrate to (`trapezoid`), or as in fill(). Empty if the cells do not suit the spacing; then
/// `why`.
std::optional<Particles> fill_fitted(const Shape& shape, const Options& options,
                                     const std::vector<MirrorPlane>& planes, std::string& why);
/// The shape has cells or cuts itself into some, and the options do not ask for the lattice.
bool is_fitted(const Shape& shape, const Options& options);
/// As fitted as the shape allows, else on the lattice; its `note` says why if that is not what the options
/// ask for.
Particles fill_best(const Shape& shape, const Options& options, const std::vector<MirrorPlane>& planes = {});

/// A body's own cells cut into pieces of about `spacing`, conformingly: opposite edges of a cell have one
/// number of pieces, and so on from cell to cell. Empty if some piece's edge would then be outside of what
/// one smoothing length suits; then `why`.
std::optional<CellMesh> cut_to_spacing(const CellMesh& mesh, double spacing, std::string& why);

/// Whole cells V_i / f_i make the derivative of the layer below a surface central: with trapezoid volumes the
/// kernel sums then satisfy summation by parts, and a uniform stress needs its traction on the surface alone.
void set_kernel_volumes(Particles& particles, KernelVolume kind);

/// Adds the mirror images of the particles within `radius` of each plane, corners of two planes included.
/// Throws std::runtime_error if two opposite planes are nearer than that.
void add_mirrored(Particles& particles, const std::vector<MirrorPlane>& planes, double radius);

}  // namespace femsph::sph
