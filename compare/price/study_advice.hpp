#pragma once
// [[advice]] of a study: compares what `femsph advise` predicts with the run that it advises.

#include "compare/price/advise.hpp"

namespace femsph::compare {

struct FollowedAdvice {
  const AdviceSpec* spec;
  Question question;
  Advice advice;
  std::optional<Outcome> outcome;                ///< nothing without advice, or if the run failed
  std::optional<double> error_vs_limit_percent;  ///< against the study's own limit or theory
};

/// For each [[advice]]: asks, and makes the advised run. `rows`: those of the study, for its limits.
std::vector<FollowedAdvice> follow_advice(const Study& study, const std::vector<Row>& rows,
                                          const Engine& engine,
                                          const std::function<void(const std::string&)>& log);

/// scene,quantity,asked,method,spacing_mm,extrapolated,predicted_cpu_s,cpu_s,predicted_error_percent,error_percent,error_vs_limit_percent,meeting,
/// methods,refusal
std::string csv(const std::vector<FollowedAdvice>& all);
std::string markdown(const std::vector<FollowedAdvice>& all);

}  // namespace femsph::compare
