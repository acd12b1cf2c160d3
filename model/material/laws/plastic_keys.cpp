// What the plastic law says of itself, and the reading of its keys.

#include <fmt/format.h>

#include "model/input/toml_fields.hpp"
#include "model/material/laws/plastic.hpp"

namespace femsph {
namespace {

/// dY/dp, given as it is or by the tangent modulus Et of the uniaxial curve: 1/Et = 1/E + 1/H.
double read_hardening(Fields& fields, double young) {
  const auto hardening = fields.quantity(
      "hardening", Need::optional, dimension::pressure, Sign::not_negative);
  const std::string range = "a number from 0 to below 1 (the tangent modulus over Young's)";
  const auto ratio = fields.number("tangent_ratio", Need::optional, range);
  if (ratio && !(*ratio >= 0 && *ratio < 1))
    fields.fault("tangent_ratio", fmt::format("\"tangent_ratio\" is {}; expected {}", *ratio, range));
  if (fields.has("hardening") == fields.has("tangent_ratio"))
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
  if (!hot)
    for (const char* key : {"m", "room", "temperature", "heat_capacity", "heat_share"})
      if (table->has(key))
        table->fault(
            key, fmt::format("\"{}\" without \"melting\"; expected both, or no effect of heat", key));
  jc.heating = capacity ? share / (density * *capacity) : 0.0;
  table->done();
  return jc;
}

/// Johnson-Cook goes with the plain law alone, and needs a component of stress across the plane.
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
  return {"plastic",
          "von Mises plasticity, hardening linearly or by Johnson and Cook",
          {{"yield", pressure, "The yield stress; A of Johnson and Cook.", true},
           {"hardening", pressure,
            "H, the slope of the yield stress over the plastic strain. Either this or \"tangent_ratio\"."},
           {"tangent_ratio", key_holds::number,
            "r = Et/E of the uniaxial curve, 0 to below 1: H = E r / (1 - r). Either this or \"hardening\"."},
           {"tension", key_holds::words(std::vector<std::string>{"none", "sign", "principal"}),
            "A limit on tension: \"sign\" takes \"tensile_strength\" as the yield stress where the mean "
            "stress is tension, \"principal\" cuts principal stresses at it. \"none\" unless given."},
           {"tensile_strength", pressure, "The limit of the tension rule.", false,
            "with \"sign\" or \"principal\""},
           {"integration", key_holds::words(integrations()),
            "How the stress is brought to the yield surface: \"return\" (unless given) maps it back, the "
            "others let it pass, for comparison."}}};
}

std::vector<KeyTable> Plastic::tables() {
  const std::string temperature = key_holds::quantity(dimension::temperature);
  return {
      {"[materials.NAME.johnson_cook]",
       "Of a plastic material, in place of \"hardening\": the yield stress is (A + B p^n) (1 + C ln(rate / "
       "reference_rate)) (1 - T*^m), T* = (T - room) / (melting - room). Without \"melting\" heat has no "
       "effect.",
       {{"B", key_holds::quantity(dimension::pressure), "The coefficient of hardening.", true},
        {"n", key_holds::number, "The exponent of the plastic strain p, above 0 and at most 1.", true},
        {"C", key_holds::number, "The coefficient of the strain rate, 0 to 1. 0 unless given."},
        {"reference_rate", key_holds::quantity(dimension::rate),
         "The plastic strain rate at which C adds nothing.", false, "with C above 0"},
        {"melting", temperature, "The melting temperature."},
        {"m", key_holds::number, "The exponent of the temperature, up to 10.", false, "with \"melting\""},
        {"room", temperature, "The temperature at which A, B and n were measured.", false,
         "with \"melting\""},
        {"temperature", temperature, "At the start. \"room\" unless given."},
        {"heat_capacity", key_holds::quantity(dimension::heat_capacity), "Per mass.", false,
         "with \"melting\""},
        {"heat_share", key_holds::number,
         "The share of the plastic work that turns to heat, 0 to 1. 0.9 unless given."}}}};
}

Plasticity Plastic::read(Fields& fields, const LawInput& in) {
  Plasticity p;
  p.yield = fields.quantity("yield", Need::required, dimension::pressure, Sign::positive).value_or(1);
  if (fields.has("johnson_cook")) {
    p.johnson_cook = read_johnson_cook(fields, in.constants.density);
    fields.quantity("hardening", Need::optional, dimension::pressure);
    fields.number("tangent_ratio", Need::optional);
  } else {
    p.hardening = read_hardening(fields, in.constants.young);
  }
  p.tension = fields
                  .choice<TensionRule>("tension", Need::optional,
                                       {{"none", TensionRule::none},
                                        {"sign", TensionRule::sign},
                                        {"principal", TensionRule::principal}})
                  .value_or(TensionRule::none);
  const bool limited = p.tension != TensionRule::none;
  p.tensile_strength = fields
                           .quantity("tensile_strength", limited ? Need::required : Need::optional,
                                     dimension::pressure, Sign::positive)
                           .value_or(0);
  if (!limited && fields.has("tensile_strength"))
    fields.fault(
        "tensile_strength",
        "\"tensile_strength\" without a tension rule; expected tension = \"sign\" or \"principal\" with it");
  p.integration = fields.choice<Integration>("integration", Need::optional, integrations())
                      .value_or(Integration::return_mapping);
  if (p.johnson_cook) check_johnson_cook(fields, p, in);
  return p;
}

std::vector<std::string> Plastic::effects(const Plasticity& p) {
  std::vector<std::string> on = {"plasticity"};
  if (p.johnson_cook) on.emplace_back("Johnson-Cook yield stress");
  if (p.tension == TensionRule::sign) on.emplace_back("tension rule sign");
  if (p.tension == TensionRule::principal) on.emplace_back("tension rule principal");
  if (p.integration == Integration::tangent) on.emplace_back("no return mapping (hypothesis 1)");
  if (p.integration == Integration::largest_stress) on.emplace_back("no return mapping (hypothesis 3)");
  if (p.integration == Integration::modulus_mistaken) on.emplace_back("no return mapping (hypothesis 8)");
  return on;
}

/// Yield stress and hardening: tension rules are for concrete.
BarYield Plastic::bar(const Plasticity& p) {
  return {p.yield, p.hardening,
          p.johnson_cook ? "hardens by Johnson-Cook, which bars do not; expected \"hardening\" or "
                           "\"tangent_ratio\""
                         : ""};
}

}  // namespace femsph
