#pragma once
// Bar and beam theory of a box that is held on x- and loaded on x+. SI units, signs as in the scene.

#include <limits>

#include "model/scene/scene.hpp"

namespace femsph::compare {

/// What one-dimensional theory needs of a scene.
struct LoadedBox {
  Point origin;                  ///< lower corner, m
  double length, height, width;  ///< along x, along y, and along z (2D: the thickness), m
  double young;     ///< E, Pa; E/(1 - nu^2) in plane strain, where the strain across the width is held
  double shear;     ///< G = E/(2 (1 + nu)), Pa, of the material itself
  double density;   ///< kg/m^3
  Point force;      ///< total of the loads at the end of their time histories, N
  bool step;        ///< the loads act in full from the start
  bool damped;      ///< by [damping] or [settling]: no history, frequency or peak is known
  double duration;  ///< of the scene, s
  double yield = std::numeric_limits<double>::infinity();  ///< Pa: elastic up to here
  double area() const { return height * width; }
  double inertia() const { return width * height * height * height / 12; }
};

/// The box of a scene for bar theory (the total force is along x) or for beam theory (it is along y).
/// Throws std::runtime_error with one sentence if the scene is not of that kind: another body, shape or
/// support, a load that turns the end about its middle, bars, a plane of symmetry, a stress beyond yield.
LoadedBox bar_of(const Scene& scene);
LoadedBox cantilever_of(const Scene& scene);

/// A bar of bilinear plastic material that flies along x onto a held end x-: what von Karman and Duwez's
/// theory of one-dimensional elastic-plastic waves says of the plateau behind the plastic front.
struct Impact {
  double speed;                  ///< m/s, towards the held end > 0
  double young, density, yield;  ///< Pa, kg/m^3, Pa
  double tangent;                ///< Et = E H/(E + H), Pa
  double stress() const;         ///< rho c V below V_y = yield/(rho c), else yield + rho c_p (V - V_y), c_p =
                                 ///< sqrt(Et/rho); Pa, > 0
  double strain() const;         ///< V/c below V_y, else yield/E + (V - V_y)/c_p; > 0
};
/// Throws std::runtime_error with one sentence if the scene is not of that kind.
Impact impact_of(const Scene& scene);
/// Moment that a rectangle carries when all of it yields, sigma_y b h^2/4, N m: of the scene's box and its
/// material.
double plastic_moment(const Scene& scene);

// Bar: one-dimensional waves of speed c = sqrt(E/rho), e.g. Timoshenko and Goodier, Theory of Elasticity,
// ch. 15.

double bar_wave_speed(const LoadedBox& bar);
/// u(x) = F x / (E A), with x from the held end.
double bar_displacement(const LoadedBox& bar, double x);
/// 4 L / c: the wave runs to the held end and back twice until the motion repeats.
double bar_period(const LoadedBox& bar);
/// Step load: the end moves on a triangle between 0 and twice the static displacement.
double bar_end_history(const LoadedBox& bar, double time);
/// Step load: stress at x, as the front F/A passes it, doubles at the held end and is taken back at the
/// loaded one.
double bar_stress_history(const LoadedBox& bar, double x, double time);

// Cantilever: Euler-Bernoulli, w = P x^2 (3 L - x)/(6 E I); Timoshenko adds the shear deflection P x/(kappa G
// A).

inline constexpr double shear_coefficient =
    5.0 / 6.0;  ///< kappa of a rectangle (E. Reissner 1945; Cowper 1966 for nu = 0)

double cantilever_deflection(const LoadedBox& beam, double x);
double cantilever_deflection_timoshenko(const LoadedBox& beam, double x);
/// sigma_xx = -M y/I with M = P (L - x), eq. 6 of the paper; y from the middle of the height, P along +y.
double cantilever_stress(const LoadedBox& beam, double x, double y);
/// beta_n L of a clamped-free beam: the n-th root of cos b cosh b = -1; 1.875104 for n = 1.
double cantilever_eigenvalue(int n);
/// f_n = beta_n^2/(2 pi L^2) sqrt(E I/(rho A)), Hz.
double cantilever_frequency(const LoadedBox& beam, int n = 1);

// Step load on a cantilever without damping, by modes (Clough and Penzien, Dynamics of Structures, ch. 19):
// with shapes normalised to integral phi^2 = L, phi_n(L) = 2 (-1)^(n+1) and phi_n''(0) = 2 (beta_n/L)^2, so
//   tip(t)  = P L^3/(3 E I)  sum_n 12/beta_n^4 (1 - cos omega_n t)
//   root(t) = P L            sum_n 4 (-1)^(n+1)/beta_n^2 (1 - cos omega_n t)

double cantilever_tip_history(const LoadedBox& beam, double time);
double cantilever_root_moment_history(const LoadedBox& beam, double time);
/// Largest magnitudes of the two within the scene's duration, with their signs.
double cantilever_tip_peak(const LoadedBox& beam);
double cantilever_root_moment_peak(const LoadedBox& beam);

}  // namespace femsph::compare
