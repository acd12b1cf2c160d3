// [limit] and [[limits]] of a study: what the runs should converge to.

#include <fmt/format.h>

#include <algorithm>

#include "compare/study/reader/study_page.hpp"
#include "compare/study/reader/study_reading.hpp"

namespace femsph::compare {

KeyTable limit_keys() {
  return {
      "[limit]",
      "The converged static solution of the elastic body, by FEM of high degree, to compare with. It holds "
      "for every scene that [[limits]] does not name.",
      {{"divisions", "a text: cells along the axes, such as \"100x10\"", "The mesh of the solution.", true},
       {"degree", key_holds::count, "The degree of the shape functions, 1 to 8. 4 unless given."}}};
}

KeyTable scene_limit_keys() {
  return {"[[limits]]",
          "The same for one scene; or Richardson's extrapolation of a ladder of runs to spacing zero, for "
          "any quantity.",
          {{"scene", "a text: the file of a scene that a run uses", "The scene that it holds for.", true},
           {"divisions", "a text: cells along the axes, such as \"100x10\"", "The mesh of the solution.",
            false, "unless \"ladder\" is given"},
           {"degree", key_holds::count, "The degree of the shape functions, 1 to 8. 4 unless given."},
           {"ladder", "a text: the name of a method in tables",
            "The method whose three or more spacings are extrapolated.", false,
            "unless \"divisions\" is given"}}};
}

namespace {

/// The keys that [limit] and [[limits]] share.
LimitSpec one_limit(Fields& fields, int dim) {
  LimitSpec limit;
  const auto text = fields.text("divisions", Need::required, "cells along the axes, such as \"100x10\"");
  limit.degree = fields.count("degree", Need::optional, 1, 8).value_or(limit.degree);
  if (!text) return limit;
  const auto cells = parse_divisions(*text);
  if (cells && (dim == 0 || ((*cells)[2] > 0) == (dim == 3)))
    limit.divisions = *cells;
  else
    fields.fault(
        "divisions", fmt::format("\"divisions\" is {}; expected cells along the axes, such as \"100x10\"",
                                 in_quotes(*text)));
  return limit;
}

/// Richardson's limit of a ladder: it needs three runs of that label and scene.
LimitSpec ladder_limit(Fields& fields, const std::string& scene, const StudyReading& reading) {
  const Study& study = reading.study;
  LimitSpec limit;
  limit.ladder = fields.text("ladder", Need::required, "the name of a method in tables").value_or("");
  const auto rungs = std::count_if(study.runs.begin(), study.runs.end(), [&](const PlannedRun& run) {
    return run.label == limit.ladder && run.scene == scene;
  });
  if (!limit.ladder.empty() && reading.runs_known &&
      require_known(fields, "ladder", "method", limit.ladder, method_labels(study), true) && rungs < 3)
    fields.fault(
        "ladder", fmt::format("{} runs {} at {} spacings; expected three or more to extrapolate from",
                              in_quotes(limit.ladder), in_quotes(scene), rungs));
  return limit;
}

void scene_limit(Fields& fields, StudyReading& reading) {
  const auto name = read_scene_name(fields, Need::required, reading);
  if (!name) return fields.accept_rest(), fields.done();
  const bool by_ladder = fields.has("ladder") || fields.misspelt({"ladder"});
  const LimitSpec limit = by_ladder ? ladder_limit(fields, *name, reading)
                                    : one_limit(fields, reading.study.scenes.at(*name).dim());
  fields.done();
  reading.study.limits[*name] = limit;
}

}  // namespace

void read_limit(Fields& root, StudyReading& reading) {
  if (auto fields = root.table(
          "limit", Need::optional, "a table with divisions = \"100x10\" and degree = 4")) {
    reading.study.limit = one_limit(*fields, 0);
    fields->done();
  }
  if (root.misspelt({"limit", "limits"})) reading.limits_known = false;
  for (Fields& fields : root.tables("limits")) scene_limit(fields, reading);
}

}  // namespace femsph::compare
