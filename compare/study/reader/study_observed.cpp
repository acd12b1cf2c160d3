#include "compare/study/reader/study_observed.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compare/reference/theory.hpp"
#include "compare/run/plan/run_result.hpp"
#include "model/input/lookup.hpp"
#include "model/results/history_columns.hpp"

namespace femsph::compare {
namespace {

std::vector<std::string> scalar_names() {
  std::vector<std::string> names;
  for (const auto& [name, si] : run_scalars()) names.push_back(name);
  return names;
}

std::string scalar_unit(const std::string& scalar) {
  for (const auto& [name, si] : run_scalars())
    if (name == scalar) return si;
  return "1";
}

/// The SI unit of a column of the history. Some scene of the study, or `scene` if that is given, must have
/// it.
std::string column_unit(const Fields& fields, const std::string& column,
                        const std::optional<std::string>& scene, const Study& study) {
  std::vector<std::string> known;
  for (const auto& [file, read] : study.scenes) {
    if (scene && *scene != file) continue;
    for (const Column& c : history_columns(read).columns) {
      if (c.name == column) return c.unit;
      if (std::find(known.begin(), known.end(), c.name) == known.end()) known.push_back(c.name);
    }
  }
  if (!known.empty())
    fields.fault("column", fmt::format("no column of a history is called {}{}", in_quotes(column),
                                       expected_names(column, known)));
  return "";
}

template <class T>
std::optional<const Quantity*> observer(const std::vector<T>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const T& o) { return o.name == name; });
  return found == list.end() ? std::nullopt : std::optional(found->quantity);
}

/// What a probe or a section of this name reads, and the components that it has in every scene.
struct Found {
  const Quantity* quantity;
  std::vector<std::string> components;
};

/// The probe or section must be in every scene of the study, or in `scene` if that is given, and read the
/// same there.
std::optional<Found> find_observer(Fields& fields, const char* key, const std::string& name,
                                   const std::optional<std::string>& scene, const Study& study) {
  std::optional<Found> found;
  const bool section = std::string(key) == "section";
  for (const auto& [file, read] : study.scenes) {
    if (scene && *scene != file) continue;
    const auto quantity = section ? observer(read.sections, name) : observer(read.probes, name);
    if (quantity && found && found->quantity != *quantity) {
      fields.fault(key, fmt::format("the {} {} reads one quantity in {} and another in other scenes; "
                                    "expected \"scene\", which selects one",
                                    key, in_quotes(name), file));
      return {};
    }
    if (quantity) {
      const auto names = component_names(**quantity, read.dim());
      if (!found || names.size() < found->components.size()) found = {*quantity, names};
      continue;
    }
    std::vector<std::string> names;
    if (section)
      for (const Section& s : read.sections) names.push_back(s.name);
    else
      for (const Probe& p : read.probes) names.push_back(p.name);
    fields.fault(key, fmt::format("no {} is called {} in {}{}", key, in_quotes(name), file,
                                  names.empty() ? "" : expected_names(name, names)));
    return {};
  }
  return found;
}

}  // namespace

std::vector<Key> observed_keys() {
  return {{"probe", "a text: a probe of the scene",
           "One of \"probe\", \"section\", \"energy\", \"scalar\" and \"column\" says what is read."},
          {"section", "a text: a section of the scene", "Its profile at the last sample."},
          {"energy", "a text: " + one_of(energy_columns()), "A column of energy of the history."},
          {"scalar", "a text: " + one_of(scalar_names()), "One number of the whole run."},
          {"column", "a text: a column of the history, such as \"contact_blow_force_x\"",
           "Any other column of the history."},
          {"component", "a text: x, xx, 1 or the like",
           "A component of what the probe or section reads. Not needed if there is only one."},
          {"unit", "a text: a unit of the same kind, such as \"mm\"",
           "The unit in tables. The SI unit unless given."}};
}

std::vector<Key> joined(std::vector<Key> all, const std::vector<Key>& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

Key theory_key() {
  return {"theory", "a text: a theory value", "A theory value to compare with: see `femsph list`."};
}
Key scene_key(const char* about) { return {"scene", "a text: the file of a scene that a run uses", about}; }

Unit read_unit(Fields& fields, const char* key, const std::optional<std::string>& name,
               const std::string& si) {
  if (!name) return {si, 1};
  try {
    return unit_named(*name, si);
  } catch (const std::invalid_argument&) {
    fields.fault(key, fmt::format("\"{}\" is {}; expected a unit of the same kind as {}", key,
                                  in_quotes(*name), in_quotes(si)));
    return {*name, 1};
  }
}

Observed read_observed(Fields& fields, const std::optional<std::string>& scene,
                       const std::string& si_of_reduced, const Study& study) {
  Observed observed;
  const auto probe = fields.text("probe", Need::optional), section = fields.text("section", Need::optional);
  const auto energy = fields.text("energy", Need::optional), scalar = fields.text("scalar", Need::optional);
  const auto column = fields.text(
      "column", Need::optional, "a column of the history, such as \"contact_blow_force_x\"");
  const auto component = fields.text("component", Need::optional);
  const auto unit = fields.text("unit", Need::optional, "a unit such as \"mm\"");
  observed.probe = probe.value_or("");
  observed.section = section.value_or("");
  observed.column = energy ? *energy : column.value_or("");
  observed.scalar = scalar.value_or("");
  if (fields.misspelt({"probe", "section", "energy", "scalar", "column", "component"})) return observed;
  if (probe.has_value() + section.has_value() + energy.has_value() + scalar.has_value() +
          column.has_value() !=
      1) {
    fields.fault(
        "probe",
        "expected one of \"probe\", \"section\", \"energy\", \"scalar\" and \"column\" in " + fields.name());
    return observed;
  }
  std::string si = scalar ? scalar_unit(*scalar) : column ? column_unit(fields, *column, scene, study) : "J";
  if (scalar && !fields.position_of(*scalar, scalar_names(), "scalar", "scalar")) return observed;
  if (column && si.empty()) return observed;
  if (energy) fields.position_of(*energy, energy_columns(), "energy", "energy");
  if (probe || section) {
    const char* key = probe ? "probe" : "section";
    const auto found = find_observer(fields, key, probe ? *probe : *section, scene, study);
    if (!found) return observed;
    const auto& known = found->components;
    observed.component = component.value_or(known.size() == 1 ? known[0] : "");
    if (std::find(known.begin(), known.end(), observed.component) == known.end())
      fields.fault(
          component ? "component" : key,
          fmt::format("the component is {}; expected {}", in_quotes(observed.component), one_of(known)));
    si = found->quantity->unit;
  }
  observed.unit = read_unit(fields, "unit", unit, si_of_reduced.empty() ? si : si_of_reduced);
  observed.si = si;
  return observed;
}

std::optional<std::string> read_theory(Fields& fields, const std::optional<std::string>& scene,
                                       const std::string& si, bool over_time, const Study& study) {
  const auto name = fields.text("theory", Need::optional, "the name of a theory value");
  if (!name) return {};
  try {
    const Theory& theory = theory_named(*name);
    if (theory.on_time() && !over_time) {
      fields.fault(
          "theory", "a theory that depends on time; expected one value (a history goes into [[series]])");
      return {};
    }
    for (const auto& [file, read] : study.scenes)
      if (!scene || *scene == file) theory.value(read, read.bodies[0].shape->lower(), 0);
    if (!si.empty() && theory.unit != si) {
      fields.fault(
          "theory", fmt::format("{} is in {}, and what is read is in {}; expected a theory of the same kind",
                                theory.name, theory.unit, si));
      return {};
    }
    return theory.name;
  } catch (const std::runtime_error& e) {
    fields.fault("theory", e.what());
    return {};
  }
}

}  // namespace femsph::compare
