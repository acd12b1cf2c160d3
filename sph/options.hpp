#pragma once
// What a user chooses of an SPH discretization, and the list of formulations to choose from.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace femsph {
class Discretization;
struct Scene;
}  // namespace femsph

namespace femsph::sph {

class Kernel;
struct MirrorPlane;
struct Particles;

enum class KernelKind { cubic_spline, wendland_c2 };
/// Mass and volume of a particle: `share` the mass of the body over the number of particles; `full` rho
/// d^dim; `trapezoid` the part of its cell that lies in the body.
enum class MassRule { share, full, trapezoid };
/// Volume of a neighbour in the kernel sums of a corrected formulation: that of its `whole` cell, however
/// much of it lies in the body, or its `own` (half a cell on a side). Mass, energy and loads always take its
/// own.
enum class KernelVolume { whole, own };
/// Which change of volume a corrected formulation gives to the law: the particle's own (`local`), or the
/// `mean` over its neighbours, which keeps the pressure from alternating where a body keeps its volume.
/// `automatic`: the mean where Poisson's ratio is above 0.4 or the material flows plastically (without a
/// tension rule), except in plane stress.
enum class Dilatation { automatic, local, mean };
/// What makes up for the missing neighbours beyond a free surface; a corrected formulation needs nothing.
enum class Boundary { none, virtual_particles, weight };

/// Artificial viscosity, eq. 5 of the paper (Monaghan); off if alpha = beta = 0.
struct Viscosity {
  double alpha = 0, beta = 0, gamma = 1.0;
  bool on() const { return alpha != 0 || beta != 0; }
};

struct Options {
  std::string formulation = "corrected";  ///< the word of one of formulations()
  double spacing = 0;                     ///< d, m
  double smoothing = 1.0;                 ///< h / d; the kernel reaches 2 h
  KernelKind kernel = KernelKind::cubic_spline;
  MassRule mass = MassRule::trapezoid;
  Boundary boundary = Boundary::none;                ///< uncorrected only
  KernelVolume kernel_volume = KernelVolume::whole;  ///< corrected only; the others take `own`
  Dilatation dilatation = Dilatation::automatic;     ///< corrected only
  /// Corrected only, scattered particles: weights for which a uniform stress is exact (projection.hpp).
  bool projection = true;
  Viscosity viscosity;  ///< classic and updated
  /// Corrected: coefficient of the hourglass control. Updated: stiffness xi of the springs of bonds, in shear
  /// moduli.
  double hourglass = 0.03;
  double jitter = 0;  ///< particles moved at random by up to this share of d (tests of scattered particles)
  /// Particles of round shapes, quadrilaterals and meshes follow their sides where they can; false: a lattice
  /// that the sides cut.
  bool fitted = true;
  bool force_lists = false;  ///< neighbour lists even on a lattice (tests, bench)
};

/// A formulation with the options that make it a method.
struct Variant {
  const char* word;   ///< the method is called "sph-" and this word
  const char* about;  ///< one line for `femsph list`
  Options options;    ///< `formulation` is filled in by the list
};

/// One file in sph/formulations/ states each.
struct Formulation {
  const char* word;  ///< of Options::formulation
  /// Its gradient is exact for linear fields everywhere, so it converges up to the surface. Options above say
  /// which of them belong to corrected formulations and which to the others.
  bool corrected = false;
  bool initial_neighbours = true;  ///< in large motion; its rows can then be projected, and volumes averaged
  bool viscosity = false;          ///< takes the artificial viscosity
  bool hourglass = false;          ///< has an hourglass control
  double bytes[2] = {
      0, 0};  ///< in large motion, of a particle in 2D and in 3D; 0: those of initial neighbours
  std::vector<Variant> variants;
  /// Throws Refusal if the options and the scene do not go with this formulation.
  void (*check)(const Scene&, std::size_t body, const Options&, const std::vector<MirrorPlane>&);
  std::unique_ptr<Discretization> (*make)(const Scene&, std::size_t body, const Options&, Particles,
                                          const Kernel&);
};

/// All formulations, in the order of `femsph list`.
const std::vector<Formulation>& formulations();
/// Throws Refusal with "did you mean".
const Formulation& formulation_named(const std::string& word);

}  // namespace femsph::sph
