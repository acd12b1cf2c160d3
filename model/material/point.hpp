#pragma once
// A single material point that follows a path of prescribed total strains, without a discretization.

#include <array>
#include <string>
#include <vector>

#include "model/material/law.hpp"

namespace femsph {

/// A point after a step; components xx yy zz xy yz zx.
struct PointState {
  std::array<double, 6> stress{};  ///< Pa
  double equivalent = 0;           ///< von Mises, Pa
  double plastic_strain = 0;       ///< equivalent
  double strain_across = 0;        ///< ezz; in plane stress a result of the law
  double plastic_work = 0;         ///< J/m^3
  double stored_energy = 0;        ///< J/m^3
};

class MaterialPoint {
 public:
  explicit MaterialPoint(const Law& law);
  /// Goes in one step to the total strain exx eyy ezz gxy gyz gzx (engineering shear strains g = 2 e). In 2D
  /// only exx, eyy and gxy are used. A law with an equation of state takes them as logarithmic strains, and
  /// gives the Cauchy stress.
  PointState advance(const std::array<double, 6>& strain);

 private:
  Law law_;
  std::array<double, 20> state_{};  ///< as advance_law keeps it
};

/// The strain components that a path can prescribe in this plane, as indices into path_names.
std::vector<int> path_components(Plane plane);
inline constexpr std::array<const char*, 6> path_names{"exx", "eyy", "ezz", "gxy", "gyz", "gzx"};

/// Reads a path in CSV: a header that names columns, then one row of total strains for each step; components
/// without a column are 0. Throws InputError with the line.
std::vector<std::array<double, 6>> read_path(const std::string& text, const std::string& file, Plane plane);

/// The result as CSV: strains, stresses (Pa), equivalent stress, plastic strain, plastic work and stored
/// energy (J/m^3).
std::string point_csv(const Law& law, Plane plane, const std::vector<std::array<double, 6>>& path);

}  // namespace femsph
