#include "model/material/laws/equation_of_state.hpp"

#include <fmt/format.h>

#include <cmath>

#include "model/input/toml_fields.hpp"
#include "model/numerics/elementary.hpp"

namespace femsph {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// e^x - 1 - x, by its series near 0.
template <class T>
T exp_beyond_linear(const T& x) {
  T series = broadcast<T>(1.0 / 39916800);  // 1/11!
  for (const double c :
       {1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5})
    series = series * x + c;
  return select((x < 0.1) & (x > -0.1), series * x * x, exponential(x) - 1.0 - x);
}
/// e^x - 1
template <class T>
T exp_minus_1(const T& x) {
  return exp_beyond_linear(x) + x;
}

const std::vector<std::pair<std::string, EquationOfState::Form>> forms = {
    {"linear", EquationOfState::Form::linear},
    {"murnaghan", EquationOfState::Form::murnaghan},
    {"mie-grueneisen", EquationOfState::Form::mie_grueneisen}};

const std::string range_of_n = "a number above 1 and at most 100 (dK/dp; about 7 for water, 4 for metals)",
                  range_of_s = "a number from 0 to 10 (the slope of shock speed over particle speed)",
                  range_of_gamma = "a number from 0 to 10 (the Grueneisen parameter)";

double read_number(Fields& table, const char* key, double least, double most, const std::string& range) {
  const auto value = table.number(key, Need::required, range);
  if (value && !(*value >= least && *value <= most))
    table.fault(key, fmt::format("\"{}\" is {}; expected {}", key, *value, range));
  return value.value_or(least);
}

}  // namespace

template <class T>
T EquationOfState::cold_pressure(const T& log_volume) const {
  if (form == Form::murnaghan) return (bulk / exponent) * exp_minus_1<T>(-exponent * log_volume);
  const T expanded = bulk * exp_minus_1<T>(-log_volume);
  if (form == Form::linear) return expanded;
  const T eta = -exp_minus_1(log_volume), room = 1.0 - s * eta;
  const T shocked = bulk * eta / (room * room) * (1.0 - 0.5 * gamma * eta);
  return select(eta < 0.0, expanded, select(room > 0.0, shocked, broadcast<T>(infinite)));
}

template <class T>
T EquationOfState::cold_energy(const T& log_volume) const {
  const T volume = exp_beyond_linear(log_volume);
  if (form == Form::linear) return bulk * volume;
  const T power = exp_beyond_linear<T>((1 - exponent) * log_volume);
  return (bulk / exponent) * (power * (1 / (exponent - 1)) + volume);
}

double EquationOfState::cut() const {
  if (form == Form::murnaghan) {
    const double x = 1 + exponent * least / bulk;
    return x > 0 ? -std::log(x) / exponent : infinite;
  }
  return least > -bulk ? -std::log1p(least / bulk) : infinite;
}

template <class T>
EquationOfState::Point<T> EquationOfState::advance(const T& from, const T& to, const Point<T>& before,
                                                   const T& heat) const {
  Point<T> now{cold_pressure(to), T{}};
  if (form == Form::mie_grueneisen) {
    const T change = exponential(from) * exp_minus_1<T>(to - from);
    const T known = before.energy - 0.5 * before.pressure * change;
    now.pressure = (now.pressure + gamma * (known + heat)) / (1.0 + 0.5 * gamma * change);
    now.pressure = select(now.pressure < least, broadcast<T>(least), now.pressure);
    now.energy = known - 0.5 * now.pressure * change;
  } else {
    now.pressure = select(now.pressure < least, broadcast<T>(least), now.pressure);
  }
  return now;
}

template <class T>
T EquationOfState::stored(const T& log_volume, const T& energy) const {
  if (form == Form::mie_grueneisen) return energy;
  const double begin = cut();
  if (!(begin < infinite)) return cold_energy(log_volume);
  const T beyond = cold_energy<double>(begin) - least * std::exp(begin) * exp_minus_1<T>(log_volume - begin);
  return select(log_volume > begin, beyond, cold_energy(log_volume));
}

template <class T>
T EquationOfState::stiffness(const T& J) const {
  if (form == Form::linear) return broadcast<T>(1.0);
  if (form == Form::murnaghan) return exponential((1 - exponent) * natural_log(J));
  const T eta = 1.0 - J, room = 1.0 - s * eta, square = room * room;
  const T shocked =
      J * J * ((1.0 + s * eta) / (square * room) * (1.0 - 0.5 * gamma * eta) + 0.5 * gamma * eta / square);
  return select(eta < 0.0, broadcast<T>(1.0), select(room > 0.0, shocked, broadcast<T>(infinite)));
}

KeyTable EquationOfState::table() {
  const std::string pressure = key_holds::quantity(dimension::pressure);
  const Key bulk{"bulk_modulus", pressure, "K, the bulk modulus at rest.", true};
  return {
      "[materials.NAME.eos]",
      "The equation of state: the pressure p as a function of J, the volume over the undeformed one. Of a "
      "fluid; "
      "and of a plastic material, whose mean stress it then gives, while \"young\" and \"poisson\" give the "
      "shear modulus alone. Only with motion = \"large\", and not in plane stress.",
      {{"equation", key_holds::words(forms), "Its form; each form has further keys, below.", true},
       {"pressure_cutoff", pressure,
        "The least pressure, 0 or negative (tension): beyond, the material cavitates at this pressure. "
        "Unless "
        "given, 0 for a fluid, and no limit for a plastic material."}},
      "equation",
      {{"linear", "p = K (1/J - 1)", {bulk}},
       {"murnaghan",
        "p = K/n (J^-n - 1); with n about 7 the equation of Tait for water",
        {bulk,
         {"exponent", key_holds::number, "n, the change of the bulk modulus with pressure, above 1.", true}}},
       {"mie-grueneisen",
        "from the shock speed us = c0 + s up over the particle speed up: p = rho0 c0^2 x / (1 - s x)^2 (1 - "
        "gamma0 x/2) + gamma0 e for x = 1 - J >= 0, rho0 c0^2 (1/J - 1) + gamma0 e for x < 0, with e the "
        "internal energy per undeformed volume",
        {{"c0", key_holds::quantity(dimension::velocity),
          "The shock speed at up = 0: the bulk speed of sound.", true},
         {"s", key_holds::number, "The slope of the shock speed over the particle speed, 0 to 10.", true},
         {"gamma0", key_holds::number, "The Grueneisen parameter, 0 to 10.", true}}}}};
}

EquationOfState EquationOfState::read(Fields& material, double density, double least) {
  EquationOfState eos;
  auto table = material.table("eos", Need::required, "a table with equation = \"linear\" or another");
  if (!table) return eos;
  const auto form = table->choice("equation", Need::required, forms);
  eos.least = table->quantity("pressure_cutoff", Need::optional, dimension::pressure).value_or(least);
  if (eos.least > 0)
    table->fault("pressure_cutoff",
                 fmt::format("\"pressure_cutoff\" is {:g} Pa; expected 0 or a negative pressure (tension)",
                             eos.least));
  if (!form) {
    table->accept_rest();
    table->done();
    return eos;
  }
  eos.form = *form;
  if (eos.form == Form::mie_grueneisen) {
    const double c0 = table->quantity("c0", Need::required, dimension::velocity, Sign::positive).value_or(1);
    eos.bulk = density * c0 * c0;
    eos.s = read_number(*table, "s", 0, 10, range_of_s);
    eos.gamma = read_number(*table, "gamma0", 0, 10, range_of_gamma);
  } else {
    eos.bulk =
        table->quantity("bulk_modulus", Need::required, dimension::pressure, Sign::positive).value_or(1);
    if (eos.form == Form::murnaghan) {
      eos.exponent = read_number(*table, "exponent", 1, 100, range_of_n);
      if (eos.exponent == 1 && table->has("exponent"))
        table->fault(
            "exponent", fmt::format("\"exponent\" is 1; expected {}, or equation = \"linear\"", range_of_n));
    }
  }
  table->done();
  return eos;
}

#define FEMSPH_FOR(T)                                                                                        \
  template EquationOfState::Point<T> EquationOfState::advance(const T&, const T&, const Point<T>&, const T&) \
      const;                                                                                                 \
  template T EquationOfState::stored(const T&, const T&) const;                                              \
  template T EquationOfState::stiffness(const T&) const;
FEMSPH_FOR(double)
FEMSPH_FOR(Pack)
#undef FEMSPH_FOR

}  // namespace femsph
