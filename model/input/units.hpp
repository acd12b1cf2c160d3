#pragma once
// Quantities with their units at the border of the program, SI inside: "25 kN" -> 25000.

#include <string>

namespace femsph {

/// What kind of quantity a key holds, in the words of the user.
struct Dimension {
  const char* si;       ///< the unit in which the program keeps it
  const char* name;     ///< with its article: "a length"
  const char* example;  ///< "10 mm"
  /// What an angle has to do with it. UDUNITS takes a radian for 1 and a hertz for 1/s, so that "1 Hz" would
  /// be a spin of 1 rad/s to it and of 2 pi rad/s to most: a quantity that can be read in two ways is
  /// refused.
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
inline constexpr Dimension density{"kg/m^3", "a density", "7850 kg/m^3"};
}  // namespace dimension

/// "a length with its unit, such as "10 mm"", for messages.
std::string expected_quantity(const Dimension& dimension);

/// A quantity such as "1000 mm" in SI. The result is finite, and zero or of a magnitude between 1e-60 and
/// 1e60, so that sums, products and quotients of a few of them neither overflow nor vanish. Throws
/// std::invalid_argument with a sentence that says what was expected. Not safe from several threads at once
/// (nor is UDUNITS-2).
double to_si(const std::string& quantity, const Dimension& dimension);

/// A unit of the tables: one of it is `factor` SI units.
struct Unit {
  std::string name;
  double factor = 1;
};

/// A unit that measures what `si` measures: "mm" for "m". Throws std::invalid_argument.
Unit unit_named(const std::string& name, const std::string& si);

}  // namespace femsph
