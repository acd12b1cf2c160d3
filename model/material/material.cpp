#include "model/material/material.hpp"

#include <utility>

#include "model/input/toml_fields.hpp"

namespace femsph {
namespace {

template <class L>
const typename L::Parameters& of_law(const LawParameters& all) {
  return std::get<typename L::Parameters>(all);
}

std::vector<std::string> words_for_bars() {
  std::vector<std::string> words;
  for (const LawEntry& law : laws())
    if (law.has_bars) words.push_back(law.entry.word);
  return words;
}

template <class L>
LawEntry entry_of() {
  LawEntry e{L::entry(), {}, L::name, false, !L::path_independent, false, false, {}, {}, {}, {}, {}};
  if constexpr (requires { L::tables(); }) e.tables = L::tables();
  if constexpr (requires { L::large_motion_only; }) e.large_motion_only = L::large_motion_only;
  if constexpr (requires { L::fluid; }) e.fluid = L::fluid;
  e.read = [](Fields& fields, const LawInput& in) -> LawParameters { return L::read(fields, in); };
  e.of = [](const LawParameters& p, const ElasticConstants& m, Plane plane) -> Law {
    if constexpr (std::is_same_v<L, Plastic>)
      if (of_law<L>(p).eos) return PlasticWithEos::of(of_law<L>(p), m, plane);
    return L::of(of_law<L>(p), m, plane);
  };
  e.effects = [](const LawParameters& p) -> std::vector<std::string> {
    if constexpr (requires { L::effects(of_law<L>(p)); })
      return L::effects(of_law<L>(p));
    else
      return {std::string(L::name) + " law"};
  };
  e.has_bars = requires(const typename L::Parameters& p) { L::bar(p); };
  e.bar = [](const LawParameters& p) -> BarYield {
    if constexpr (requires { L::bar(of_law<L>(p)); })
      return L::bar(of_law<L>(p));
    else
      return {
          0, 0,
          "has the law \"" + L::entry().word + "\", which bars do not; expected " + one_of(words_for_bars())};
  };
  e.plasticity = [](const LawParameters& p) -> const Plasticity* {
    if constexpr (requires { L::plasticity(of_law<L>(p)); })
      return L::plasticity(of_law<L>(p));
    else
      return nullptr;
  };
  return e;
}

template <class... L>
std::vector<LawEntry> entries_of(LawList<L...>) {
  return {entry_of<L>()...};
}

}  // namespace

const std::vector<LawEntry>& laws() {
  static const std::vector<LawEntry> all = entries_of(Laws{});
  return all;
}

}  // namespace femsph
