#pragma once
// Quantities with units in input files, converted to SI: "25 kN" -> 25000.

#include <string>

namespace femsph {

/// A kind of quantity.
struct Dimension {
  const char* si;       ///< its SI unit
  const char* name;     ///< its name with the article: "a length"
  const char* example;  ///< "10 mm"
  /// Whether its unit must contain an angle (rotation), must not (rate), or does not matter. For UDUNITS a
  /// radian is 1 and a hertz is 1/s, so that it reads "1 Hz" as 1 rad/s, where most people mean 2 pi rad/s:
  /// ambiguous quantities are refused.
  enum class Angle { none, must, foreign_to_rate } angle = Angle::none;
};

namespace dimension {
inline constexpr Dimension length{"m", "a length", "10 mm"};
inline constexpr Dimension area{"m^2", "an area", "250 mm^2"};
inline constexpr Dimension time{"s", "a time", "50 ms"};
inline constexpr Dimension rate{"1/s", "a rate", "100 1/s", Dimension::Angle::foreign_to_rate};
inline constexpr Dimension rotation{"1/s", "a rate of rotation", "50 rad/s", Dimension::Angle::must};
inline constexpr Dimension velocity{"m/s", "a velocity", "1 m/s"};
inline constexpr Dimension acceleration{"m/s^2", "an acceleration", "9.81 m/s^2"};
inline constexpr Dimension mass{"kg", "a mass", "300 kg"};
inline constexpr Dimension force{"N", "a force", "25 kN"};
inline constexpr Dimension pressure{"Pa", "a pressure", "210 GPa"};
inline constexpr Dimension temperature{"K", "a temperature", "298 K"};
inline constexpr Dimension heat_capacity{"J/(kg K)", "a heat capacity", "477 J/(kg K)"};
inline constexpr Dimension viscosity{"Pa s", "a dynamic viscosity", "1e-3 Pa s"};
inline constexpr Dimension density{"kg/m^3", "a density", "7850 kg/m^3"};
}  // namespace dimension

/// "a length with its unit, such as "10 mm"", for messages.
std::string expected_quantity(const Dimension& dimension);

/// Converts a quantity such as "1000 mm" to SI. The result is zero, or its magnitude lies between 1e-60 and
/// 1e60, so that products and quotients of a few such numbers do not overflow or underflow. Throws
/// std::invalid_argument with a sentence that says what was expected. Not thread-safe, as UDUNITS-2.
double to_si(const std::string& quantity, const Dimension& dimension);

/// A unit of output tables: `factor` SI units.
struct Unit {
  std::string name;
  double factor = 1;
};

/// The unit `name`, of the same kind as the unit `si`: "mm" for "m". Throws std::invalid_argument.
Unit unit_named(const std::string& name, const std::string& si);

}  // namespace femsph
