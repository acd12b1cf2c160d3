#include "compare/price/study_advice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compare/measure/errors.hpp"

namespace femsph::compare {
namespace {

std::string asked(const AdviceSpec& spec) {
  return spec.error ? fmt::format("error {:g} %", *spec.error) : fmt::format("within {:g} s", *spec.within);
}

/// The limit or theory that the study compares the quantity with.
std::optional<double> limit_in(const std::vector<Row>& rows, const AdviceSpec& spec) {
  for (const Row& row : rows)
    if (row.scene == spec.scene && row.quantity == spec.quantity && (row.limit || row.theory))
      return row.limit ? row.limit : row.theory;
  return {};
}

}  // namespace

std::vector<FollowedAdvice> follow_advice(const Study& study, const std::vector<Row>& rows,
                                          const Engine& engine,
                                          const std::function<void(const std::string&)>& log) {
  std::vector<FollowedAdvice> all;
  for (const AdviceSpec& spec : study.advice) {
    const Scene& scene = study.scenes.at(spec.scene);
    Question question;
    question.quantity = *std::find_if(study.quantities.begin(), study.quantities.end(),
                                      [&](const QuantitySpec& q) { return q.name == spec.quantity; });
    question.methods = spec.methods.empty() ? usual_methods() : spec.methods;
    question.error = spec.error, question.within = spec.within, question.budget = spec.budget;
    FollowedAdvice one{&spec, question, {}, {}, {}};
    try {
      one.advice = advise(scene, question, engine);
      if (one.advice.best) one.outcome = follow(scene, question, one.advice, engine);
    } catch (const std::exception& e) {
      one.advice.refusal = e.what();
    }
    if (const auto limit = limit_in(rows, spec); limit && one.outcome)
      one.error_vs_limit_percent = percent_error(one.outcome->value, *limit);
    if (log)
      log(describe(scene, question, one.advice) +
          (one.outcome ? describe(one.advice, question, *one.outcome) : ""));
    all.push_back(std::move(one));
  }
  return all;
}

std::string csv(const std::vector<FollowedAdvice>& all) {
  std::string text =
      "scene,quantity,asked,method,spacing_mm,extrapolated,predicted_cpu_s,cpu_s,predicted_error_percent,"
      "error_percent,error_vs_limit_percent,meeting,methods,refusal\r\n";
  for (const FollowedAdvice& one : all) {
    const auto& best = one.advice.best;
    text += csv_line(
        {one.spec->scene, one.spec->quantity, asked(*one.spec),
         best ? one.advice.methods[best->method].method.name : "",
         best ? csv_number(1e3 * best->spacing) : "",
         !best                ? ""
         : best->extrapolated ? "yes"
                              : "no",
         best ? csv_number(best->cpu) : "", one.outcome ? csv_number(one.outcome->cpu) : "",
         best ? csv_number(best->error) : "", one.outcome ? csv_number(one.outcome->error) : "",
         csv_number(one.error_vs_limit_percent), fmt::format("{}", one.advice.meeting),
         fmt::format("{}", one.advice.methods.size()), one.advice.refusal});
  }
  return text;
}

std::string markdown(const std::vector<FollowedAdvice>& all) {
  std::vector<std::vector<std::string>> cells{
      {"quantity", "asked", "advised", "methods that agree", "predicted CPU s", "measured", "ratio",
       "predicted error %", "error against the limit of advise %", "error against the study's limit %"}};
  for (const FollowedAdvice& one : all) {
    const auto& best = one.advice.best;
    if (!best) {
      cells.push_back(
          {one.spec->quantity, asked(*one.spec), "none: " + one.advice.refusal, "", "", "", "", "", "", ""});
      continue;
    }
    cells.push_back(
        {one.spec->quantity, asked(*one.spec),
         fmt::format("{}, {:.3g} mm{}", one.advice.methods[best->method].method.name, 1e3 * best->spacing,
                     best->extrapolated ? " (extrapolated)" : ""),
         fmt::format("{} of {}", one.advice.meeting, one.advice.methods.size()), rounded(best->cpu, 2),
         one.outcome ? rounded(one.outcome->cpu, 2) : "",
         one.outcome ? fmt::format("{:.2f}", one.outcome->cpu / best->cpu) : "", rounded(best->error, 2),
         one.outcome ? fmt::format("{:+.2g}", one.outcome->error) : "",
         one.error_vs_limit_percent ? fmt::format("{:+.2g}", *one.error_vs_limit_percent) : ""});
  }
  return "### `femsph advise`, followed\n\n" + markdown_table(cells);
}

}  // namespace femsph::compare
