#pragma once
// One material point driven along a path of total strains: what a law does, without any discretization.

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
  double strain_across = 0;        ///< ezz; in plane stress it follows from the law
  double plastic_work = 0;         ///< J/m^3
  double stored_energy = 0;        ///< J/m^3
};

class MaterialPoint {
 public:
  explicit MaterialPoint(const Law& law);
  /// Goes in one step to the total strain exx eyy ezz gxy gyz gzx (engineering shear g = 2 e). In 2D only
  /// exx, eyy, gxy count.
  PointState advance(const std::array<double, 6>& strain);

 private:
  Law law_;
  std::array<double, 16> state_{};  ///< as advance_law keeps it
};

/// The columns a path may have: exx eyy ezz gxy gyz gzx, less those that the plane does not leave free.
std::vector<int> path_components(Plane plane);
inline constexpr std::array<const char*, 6> path_names{"exx", "eyy", "ezz", "gxy", "gyz", "gzx"};

/// Reads a path: a header naming columns, then one row of total strains a step; a column not named is 0.
/// Throws InputError with the line.
std::vector<std::array<double, 6>> read_path(const std::string& text, const std::string& file, Plane plane);

/// The answer as CSV: the path's strains, stress, equivalent stress and plastic strain, ezz, plastic work and
/// stored energy.
std::string point_csv(const Law& law, Plane plane, const std::vector<std::array<double, 6>>& path);

}  // namespace femsph
