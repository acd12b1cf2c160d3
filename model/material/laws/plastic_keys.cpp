// The plastic law: its description, its keys and their reading.

#include <fmt/format.h>

#include "model/input/toml_fields.hpp"
#include "model/material/laws/plastic.hpp"

namespace femsph {
namespace {

/// H = dY/dp, given directly or by the tangent modulus Et of a uniaxial test: 1/Et = 1/E + 1/H.
double read_hardening(Fields& fields, double young) {
  const auto hardening = fields.quantity(
      "hardening", Need::optional, dimension::pressure, Sign::not_negative);
  const std::string range = "a number from 0 to below 1 (the tangent modulus over Young's)";
  const auto ratio = fields.number("tangent_ratio", Need::optional, range);
  if (ratio && !(*ratio >= 0 && *ratio < 1))
    fields.fault("tangent_ratio", fmt::format("\"tangent_ratio\" is {}; expected {}", *ratio, range));
  if (fields.has("hardening") == fields.has("tangent_ratio") &&
      !fields.misspelt({"hardening", "tangent_ratio", "johnson_cook"}))
    fields.fault(fields.has("hardening") ? "hardening" : "law",
                 fmt::format("{} in {}; expected one of them: \"hardening\" is H, Pa per plastic strain, "
                             "\"tangent_ratio\" is r = Et/E, H = E r / (1 - r)",
                             fields.has("hardening") ? "both \"hardening\" and \"tangent_ratio\""
                                                     : "neither \"hardening\" nor \"tangent_ratio\"",
                             fields.name()));
  return hardening.value_or(ratio ? young * *ratio / (1 - *ratio) : 0.0);
}

/// [materials.NAME.johnson_cook]; `density` of the material, kg/m^3.
JohnsonCook read_johnson_cook(Fields& material, double density) {
  JohnsonCook jc;
  auto table = material.table(
      "johnson_cook", Need::required, "a table with B, n and what else the metal has");
  if (!table) return jc;
  const auto number = [&](const char* key, Need need, double otherwise, double least, double most,
                          const std::string& expected) {
    const auto value = table->number(key, need, expected);
    if (value && !(*value >= least && *value <= most))
      table->fault(key, fmt::format("\"{}\" is {}; expected {}", key, *value, expected));
    return value.value_or(otherwise);
  };
  jc.B = table->quantity("B", Need::required, dimension::pressure, Sign::not_negative).value_or(0);
  jc.n = number(
      "n", Need::required, 1, 1e-3, 1, "a number above 0 and at most 1 (the exponent of the plastic strain)");
  jc.C = number("C", Need::optional, 0, 0, 1, "a number from 0 to 1 (what a rate e times as high adds)");
  jc.rate = table
                ->quantity("reference_rate", jc.C > 0 ? Need::required : Need::optional, dimension::rate,
                           Sign::positive)
                .value_or(1);
  const bool hot = table->has("melting");
  const Need with_heat = hot ? Need::required : Need::optional;
  jc.melting = table->quantity("melting", Need::optional, dimension::temperature, Sign::positive).value_or(0);
  jc.m = number("m", with_heat, 1, 1e-3, 10, "a number above 0 (the exponent of the temperature)");
  jc.room = table->quantity("room", with_heat, dimension::temperature, Sign::positive).value_or(0);
  jc.start = table->quantity("temperature", Need::optional, dimension::temperature, Sign::positive)
                 .value_or(jc.room);
  const auto capacity = table->quantity("heat_capacity", with_heat, dimension::heat_capacity, Sign::positive);
  const double share = number("heat_share", Need::optional, 0.9, 0, 1,
                              "a number from 0 to 1 (the share of plastic work that turns to heat)");
  if (hot && jc.melting <= jc.room)
    table->fault(
        "melting",
        fmt::format("\"melting\" is {:g} K, not above \"room\", {:g} K; expected the higher of the two",
                    jc.melting, jc.room));
  if (!hot && !table->misspelt({"melting"}))
    for (const char* key : {"m", "room", "temperature", "heat_capacity", "heat_share"})
      if (table->has(key))
        table->fault(
            key, fmt::format("\"{}\" without \"melting\"; expected both, or no effect of heat", key));
  jc.heating = capacity ? share / (density * *capacity) : 0.0;
  table->done();
  return jc;
}

/// Johnson-Cook can be combined neither with a tension rule nor with another integration, nor with plane
/// stress.
void check_johnson_cook(Fields& fields, const Plasticity& p, const LawInput& in) {
  for (const char* key : {"hardening", "tangent_ratio"})
    if (fields.has(key))
      fields.fault(
          key,
          fmt::format(
              "\"{}\" with \"johnson_cook\", which says how the metal hardens; expected one of them", key));
  if (p.tension != TensionRule::none)
    fields.fault("tension", "a tension rule with \"johnson_cook\"; expected none");
  if (p.integration != Integration::return_mapping)
    fields.fault("integration", "\"integration\" with \"johnson_cook\"; expected \"return\"");
  if (in.plane == Plane::stress)
    fields.fault("johnson_cook",
                 "\"johnson_cook\" in plane stress; expected plane = \"strain\" or \"none\" in [model]");
}

/// The table "eos". It can be combined neither with a tension rule nor with another integration, nor with
/// plane stress.
EquationOfState read_eos(Fields& fields, const Plasticity& p, const LawInput& in) {
  if (p.tension != TensionRule::none)
    fields.fault("tension", "a tension rule with \"eos\"; expected none, or \"pressure_cutoff\" in \"eos\"");
  if (p.integration != Integration::return_mapping)
    fields.fault("integration", "\"integration\" with \"eos\"; expected \"return\"");
  if (in.plane == Plane::stress)
    fields.fault("eos", "\"eos\" in plane stress; expected plane = \"strain\" or \"none\" in [model]");
  return EquationOfState::read(fields, in.constants.density, -std::numeric_limits<double>::infinity());
}

}  // namespace

const std::vector<std::pair<std::string, Integration>>& integrations() {
  static const std::vector<std::pair<std::string, Integration>> words = {
      {"return", Integration::return_mapping},
      {"no-return-1", Integration::tangent},
      {"no-return-3", Integration::largest_stress},
      {"no-return-8", Integration::modulus_mistaken}};
  return words;
}

Entry Plastic::entry() {
  const std::string pressure = key_holds::quantity(dimension::pressure);
  return {
      "plastic",
      "von Mises plasticity with linear hardening, or the Johnson-Cook law",
      {{"yield", pressure, "The initial yield stress; A of the Johnson-Cook law.", true},
       {"hardening", pressure,
        "The plastic modulus H: the slope of the yield stress over the plastic strain. Give this or "
        "\"tangent_ratio\"."},
       {"tangent_ratio", key_holds::number,
        "The ratio r of the tangent modulus to Young's modulus in a uniaxial test, from 0 to below 1; H "
        "= E r / (1 - r). Give this or \"hardening\"."},
       {"tension", key_holds::words(std::vector<std::string>{"none", "sign", "principal"}),
        "How tension is limited. \"none\": as compression. \"sign\": the yield stress is "
        "\"tensile_strength\" where the mean stress is tension. \"principal\": no principal stress "
        "exceeds \"tensile_strength\" (Rankine). \"none\" unless given."},
       {"tensile_strength", pressure, "The tensile strength, for \"tension\".", false,
        "with \"sign\" or \"principal\""},
       {"integration", key_holds::words(integrations()),
        "How the stress follows the strain beyond yield. \"return\": return mapping (backward Euler). "
        "The others do without; they are hypotheses about published results, for comparison "
        "(model/material/README.md). \"return\" unless given."}}};
}

std::vector<KeyTable> Plastic::tables() {
  const std::string temperature = key_holds::quantity(dimension::temperature);
  return {
      {"[materials.NAME.johnson_cook]",
       "The yield stress of Johnson and Cook, for a plastic material, instead of \"hardening\": (A + B p^n) "
       "(1 + C ln(rate / reference_rate)) (1 - T*^m), T* = (T - room) / (melting - room), with p the plastic "
       "strain and \"rate\" its rate. Without \"melting\" there is no effect of temperature.",
       {{"B", key_holds::quantity(dimension::pressure), "The hardening coefficient.", true},
        {"n", key_holds::number, "The hardening exponent, above 0 and at most 1.", true},
        {"C", key_holds::number,
         "The coefficient of the strain rate, 0 to 1. 0, no effect of the rate, unless given."},
        {"reference_rate", key_holds::quantity(dimension::rate),
         "The plastic strain rate of the test that gave A, B and n.", false, "with C above 0"},
        {"melting", temperature, "The melting temperature."},
        {"m", key_holds::number, "The exponent of the temperature, above 0 and up to 10.", false,
         "with \"melting\""},
        {"room", temperature, "The temperature of the test that gave A, B and n.", false, "with \"melting\""},
        {"temperature", temperature, "The temperature at the start. \"room\" unless given."},
        {"heat_capacity", key_holds::quantity(dimension::heat_capacity), "The heat capacity per mass.", false,
         "with \"melting\""},
        {"heat_share", key_holds::number,
         "The fraction of the plastic work that becomes heat, 0 to 1. 0.9 unless given."}}}};
}

Plasticity Plastic::read(Fields& fields, const LawInput& in) {
  Plasticity p;
  p.yield = fields.quantity("yield", Need::required, dimension::pressure, Sign::positive).value_or(1);
  if (fields.has("johnson_cook")) {
    p.johnson_cook = read_johnson_cook(fields, in.constants.density);
    fields.quantity("hardening", Need::optional, dimension::pressure);
    fields.number("tangent_ratio", Need::optional);
  } else {
    fields.accept("johnson_cook");  // for "did you mean"
    p.hardening = read_hardening(fields, in.constants.young);
  }
  const auto tension = fields.choice<TensionRule>(
      "tension", Need::optional,
      {{"none", TensionRule::none}, {"sign", TensionRule::sign}, {"principal", TensionRule::principal}});
  const bool tension_faulty = fields.misspelt({"tension"}) || (fields.has("tension") && !tension);
  p.tension = tension.value_or(TensionRule::none);
  const bool limited = p.tension != TensionRule::none;
  p.tensile_strength = fields
                           .quantity("tensile_strength", limited ? Need::required : Need::optional,
                                     dimension::pressure, Sign::positive)
                           .value_or(0);
  if (!limited && fields.has("tensile_strength") && !tension_faulty)
    fields.fault(
        "tensile_strength",
        "\"tensile_strength\" without a tension rule; expected tension = \"sign\" or \"principal\" with it");
  p.integration = fields.choice<Integration>("integration", Need::optional, integrations())
                      .value_or(Integration::return_mapping);
  if (p.johnson_cook) check_johnson_cook(fields, p, in);
  if (fields.has("eos"))
    p.eos = read_eos(fields, p, in);
  else
    fields.accept("eos");  // for "did you mean"
  return p;
}

std::vector<std::string> Plastic::effects(const Plasticity& p) {
  std::vector<std::string> on = {"plasticity"};
  if (p.johnson_cook) on.emplace_back("Johnson-Cook yield stress");
  if (p.eos) on.emplace_back("equation of state");
  if (p.tension == TensionRule::sign) on.emplace_back("tension rule sign");
  if (p.tension == TensionRule::principal) on.emplace_back("tension rule principal");
  if (p.integration == Integration::tangent) on.emplace_back("no return mapping (hypothesis 1)");
  if (p.integration == Integration::largest_stress) on.emplace_back("no return mapping (hypothesis 3)");
  if (p.integration == Integration::modulus_mistaken) on.emplace_back("no return mapping (hypothesis 8)");
  return on;
}

/// Bars ignore the tension rule.
BarYield Plastic::bar(const Plasticity& p) {
  if (p.eos)
    return {p.yield, p.hardening, "has an equation of state, which bars do not; expected no \"eos\""};
  return {p.yield, p.hardening,
          p.johnson_cook
              ? "hardens by Johnson-Cook, which bars do not; expected \"hardening\" or \"tangent_ratio\""
              : ""};
}

}  // namespace femsph
