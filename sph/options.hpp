#pragma once
// What a user chooses of an SPH discretization.

namespace femsph::sph {

enum class Formulation { classic, corrected };
enum class KernelKind { cubic_spline, wendland_c2 };
/// Mass (and volume) of a particle: `share` true mass / N; `full` rho d^dim; `trapezoid` the part of its cell
/// that lies in the body.
enum class MassRule { share, full, trapezoid };
/// Volume that a neighbour has in the kernel sums of the corrected form: that of its whole cell, however much
/// of it lies in the body, or its own (half a cell on a side). Mass, energy and loads always take its own.
enum class KernelVolume { whole, own };
/// Which change of volume the law is given (corrected only): the particle's own, or the mean over its
/// neighbours, which keeps the pressure from alternating where a body keeps its volume. automatic: the mean
/// where Poisson's ratio is above 0.4 or the material flows plastically (without a tension rule), except in
/// plane stress.
enum class Dilatation { automatic, local, mean };
/// What makes up for the missing neighbours beyond a free surface (classic only; corrected needs none).
enum class Boundary { none, virtual_particles, weight };

/// Artificial viscosity, eq. 5 of the paper (Monaghan): alpha = beta = 0 switches it off.
struct Viscosity {
  double alpha = 0, beta = 0, gamma = 1.0;
  bool on() const { return alpha != 0 || beta != 0; }
};

struct Options {
  Formulation formulation = Formulation::corrected;
  double spacing = 0;      ///< d, m
  double smoothing = 1.0;  ///< h / d; the kernel reaches 2 h
  KernelKind kernel = KernelKind::cubic_spline;
  MassRule mass = MassRule::trapezoid;
  Boundary boundary = Boundary::none;
  KernelVolume kernel_volume = KernelVolume::whole;  ///< corrected only; classic takes its own
  Dilatation dilatation = Dilatation::automatic;
  bool projection = true;  ///< corrected on scattered particles: weights made so that a uniform stress is
                           ///< exact (projection.hpp)
  Viscosity viscosity;
  double hourglass = 0.03;  ///< coefficient of the hourglass control of the corrected formulation
  double jitter = 0;   ///< particles moved at random by up to this share of d (tests; neighbour-list path)
  bool fitted = true;  ///< particles of round shapes, quadrilaterals and meshes follow their sides where they
                       ///< can; false: a lattice that sides cut
  bool force_lists = false;  ///< use neighbour lists even on a lattice (tests, bench)
};

}  // namespace femsph::sph
