#pragma once
// Equations of state: the pressure of a material point from its volume ratio J = rho0/rho and its internal
// energy. For law = "fluid" and for plastic materials with a table "eos".
//
//   linear           p = K (1/J - 1)
//   murnaghan        p = K/n (J^-n - 1)     (Murnaghan, Proc. Natl. Acad. Sci. 30 (1944) 244-247; n is dK/dp
//   at
//                    p = 0. Water with n about 7: the equation of Tait in the form of Cole, Underwater
//                    Explosions, 1948)
//   mie-grueneisen   from the line us = c0 + s up of shock speed over particle speed. With eta = 1 - J, K =
//                    rho0 c0^2, and e the internal energy per undeformed volume:
//                      J <= 1   p = K eta/(1 - s eta)^2 (1 - gamma0 eta/2) + gamma0 e
//                      J > 1    p = K (1/J - 1) + gamma0 e
//                    This is *EOS_GRUNEISEN of LS-DYNA with S2 = S3 = a = 0: gamma rho is constant. Behind a
//                    shock from rest, where e = p eta/2, it gives p = K eta/(1 - s eta)^2.
//
// No pressure is below `least` (the cut-off): a fluid cavitates there.
//
// Stored energy per undeformed volume. Linear and murnaghan: the integral of -p dJ from 1 to J as a function
// of J alone, with the cut-off. mie-grueneisen: the sum of -(p_n + p_n+1)/2 (J_n+1 - J_n); p_n+1 depends
// linearly on this sum, which gives it in closed form. There e is this sum and the work that the point has
// dissipated.

#include <limits>

#include "model/input/keys.hpp"
#include "model/input/need.hpp"
#include "model/numerics/tensor.hpp"

namespace femsph {

struct EquationOfState {
  enum class Form { linear, murnaghan, mie_grueneisen };
  Form form = Form::linear;
  double bulk = 1;                                          ///< K: the bulk modulus at J = 1 and e = 0, Pa
  double exponent = 1;                                      ///< n; murnaghan
  double s = 0, gamma = 0;                                  ///< mie-grueneisen
  double least = -std::numeric_limits<double>::infinity();  ///< the least pressure, Pa; at most 0

  /// The table [materials.NAME.eos].
  static KeyTable table();
  /// Reads the table of a material with `density`, kg/m^3. `least` where it does not give "pressure_cutoff".
  static EquationOfState read(Fields& material, double density, double least);

  /// A point at the end of a step.
  template <class T>
  struct Point {
    T pressure;  ///< Pa
    T energy;    ///< the sum of -p dJ, Pa; 0 for linear and murnaghan
  };
  /// From ln J = `from` to `to` (J: their exponentials). `before`: the point at `from`; `heat`: the
  /// dissipated work at the end of the step, per undeformed volume.
  template <class T>
  Point<T> advance(const T& from, const T& to, const Point<T>& before, const T& heat) const;

  /// The energy stored by the pressure, J per undeformed m^3; `energy` of the point.
  template <class T>
  T stored(const T& log_volume, const T& energy) const;

  /// -J^2 dp/dJ over K: by how much the point is stiffer than at rest (model/material/stiffening.hpp). On the
  /// Hugoniot for mie-grueneisen; infinite where 1 - s eta <= 0, which no shock reaches. Without the cut-off.
  template <class T>
  T stiffness(const T& J) const;

 private:
  template <class T>
  T cold_pressure(const T& log_volume) const;  ///< at e = 0, without the cut-off
  template <class T>
  T cold_energy(const T& log_volume) const;  ///< linear, murnaghan; without the cut-off
  double cut() const;                        ///< ln J where the cut-off begins; linear, murnaghan
};

}  // namespace femsph
