#include "compare/program/catalogues.hpp"

#include <fmt/format.h>

#include "compare/measure/reductions.hpp"
#include "compare/reference/theory.hpp"
#include "compare/report/readme.hpp"
#include "compare/report/table.hpp"
#include "compare/run/plan/method_option.hpp"
#include "model/motion/effects/catalogue.hpp"
#include "model/scene/quantities/quantity.hpp"
#include "model/scene/reader/scene_page.hpp"

namespace femsph::compare {
namespace {

std::vector<Entry> method_entries(bool fem) {
  std::vector<Entry> all;
  for (const Method& method : methods())
    if (method.is_fem() == fem) all.push_back({method.name, method.about});
  return all;
}

std::vector<Entry> option_entries() {
  std::vector<Entry> all;
  for (const MethodOption& option : method_options())
    all.push_back({option.word, option.about + ": " + option.holds()});
  return all;
}

std::vector<Entry> theory_entries() {
  std::vector<Entry> all;
  for (const Theory& theory : theories())
    all.push_back({theory.name, fmt::format("{} ({})", theory.formula, theory.unit)});
  return all;
}

/// The effects by the names that `check` prints, with the tables of a scene that switch them on.
std::vector<Entry> effects_entries() {
  std::vector<Entry> all;
  for (const EffectEntry& effect : effects()) {
    all.push_back({effect.word, effect.about + (effect.asked_by.empty() ? "" : ": " + effect.asked_by)});
  }
  return all;
}

}  // namespace

std::vector<Catalogue> catalogues() {
  return {{"laws", "laws (law = .. in [materials.NAME])", scene_page().at("materials.NAME").entries},
          {"shapes", "shapes (shape = .. in [bodies.NAME])", scene_page().at("bodies.NAME").entries},
          {"effects", "effects (switched on by tables of a scene; `femsph check` lists those on and off)",
           effects_entries()},
          {"quantities", "quantities (quantity = .. in [[probes]] and [[sections]])", quantity_entries()},
          {"elements", "elements (--solver; methods in [[runs]])", method_entries(true)},
          {"formulations", "SPH formulations (--solver; methods in [[runs]])", method_entries(false)},
          {"options", "options of methods (options in [[runs]]; most on the command line)", option_entries()},
          {"reductions", "reductions (reduce = .. in [[quantities]])", reduction_entries()},
          {"theory-values", "theory values (theory in [[quantities]] and [[series]])", theory_entries()}};
}

std::string to_markdown(const Catalogue& catalogue) {
  std::vector<std::vector<std::string>> cells = {{"word", "meaning"}};
  for (const Entry& entry : catalogue.entries) cells.push_back({"`" + entry.word + "`", entry.about});
  return markdown_table(cells);
}

std::string with_catalogues(const std::string& readme) {
  std::string text = readme;
  for (const Catalogue& catalogue : catalogues())
    if (has_table(text, catalogue.kind)) text = with_table(text, to_markdown(catalogue), catalogue.kind);
  return text;
}

}  // namespace femsph::compare
