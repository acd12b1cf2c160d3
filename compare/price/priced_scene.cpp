#include "compare/price/priced_scene.hpp"

#include <algorithm>
#include <limits>

namespace femsph::compare {
namespace {

/// The rows of the quantity of a [[price]].
std::vector<const Row*> rows_of_price(const std::vector<Row>& rows, const Study& study, const PriceSpec& spec,
                                      const std::string& file) {
  std::vector<const Row*> found;
  for (const Row& row : rows)
    if (row.scene == file && row.study == study.name && row.quantity == spec.quantity) found.push_back(&row);
  return found;
}

/// The rung of a row; its reference is noted in `scene`. Nothing if the row has no error or no CPU time.
std::optional<PricedRung> rung_of(const Row& row, PricedScene& scene) {
  const auto error = error_of(row, scene.spec->reference);
  if (!error || !row.spacing_mm || !row.total_cpu_s || row.settled == false) return {};
  if (scene.spec->reference == Reference::theory)
    scene.reference = row.theory;
  else
    scene.reference = row.limit, scene.known_percent = row.limit_known_percent;
  return PricedRung{
      *row.spacing_mm,
      *error,
      *row.total_cpu_s,
      row.steps.value_or(0),
      row.units.value_or(0),
      row.dof.value_or(0),
      row.memory_mb.value_or(0),
      row.total_cpu_min_s.value_or(0),
      row.total_cpu_max_s.value_or(0)};
}

/// Adds the ladder of a method, if it has rungs.
void add_ladder(const std::string& method, const std::vector<const Row*>& rows, int dim, PricedScene& scene) {
  std::vector<PricedRung> rungs;
  double spread = 0, nanoseconds = 0, finest = std::numeric_limits<double>::infinity();
  for (const Row* row : rows) {
    if (row->method != method) continue;
    const auto rung = rung_of(*row, scene);
    if (!rung) continue;
    rungs.push_back(*rung);
    if (rung->cpu > 0.05) spread = std::max(spread, 100 * (rung->cpu_max - rung->cpu_min) / rung->cpu);
    if (rung->spacing < finest) finest = rung->spacing, nanoseconds = row->ns_per_unit_step.value_or(0);
  }
  if (rungs.empty()) return;
  const double known = scene.spec->reference == Reference::limit ? scene.known_percent.value_or(0) : 0;
  scene.methods.push_back({method, PricedLadder(std::move(rungs), dim, known), spread, nanoseconds});
}

}  // namespace

std::vector<PricedScene> priced_scenes(const Study& study, const std::vector<Row>& rows) {
  std::vector<PricedScene> scenes;
  for (const PriceSpec& spec : study.prices) {
    const auto quantity = std::find_if(study.quantities.begin(), study.quantities.end(),
                                       [&](const QuantitySpec& q) { return q.name == spec.quantity; });
    const std::string file = quantity->scene.value_or(study.scenes.begin()->first);
    const auto own = study.limits.find(file);
    const std::string reference = own != study.limits.end() ? own->second.ladder : "";
    PricedScene scene{&spec, {}, {}, {}, quantity->observed.unit.name, "no run gave a value"};
    const auto priced = rows_of_price(rows, study, spec, file);
    std::vector<std::string> methods;
    for (const Row* row : priced) {
      if (row->value)
        scene.nothing = row->limit_doubt.empty() ? "there is no reference for an error" : row->limit_doubt;
      if (row->method != reference && std::find(methods.begin(), methods.end(), row->method) == methods.end())
        methods.push_back(row->method);
    }
    for (const std::string& method : methods) add_ladder(method, priced, study.scenes.at(file).dim(), scene);
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

}  // namespace femsph::compare
