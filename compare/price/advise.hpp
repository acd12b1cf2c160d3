#pragma once
// Which method, how fine? A short ladder of a scene with each method, and what it says.

#include "compare/price/priced_ladder.hpp"
#include "compare/study/study_runner.hpp"

namespace femsph::compare {

struct Question {
  QuantitySpec quantity;  ///< of which number; theory and reference are not looked at
  std::vector<Method> methods;
  std::optional<double> error;   ///< percent: the least time for this error
  std::optional<double> within;  ///< s of CPU: the least error in this time
  double budget = 30;            ///< s of CPU for all ladders together
  double safety = 0.98;
};

/// What one method has shown.
struct MethodEvidence {
  Method method;
  std::vector<int> divisions;     ///< of the shortest side; one for each rung
  std::vector<PricedRung> rungs;  ///< errors once there is a reference
  std::vector<double> values;
  std::string trouble;                 ///< why it has fewer rungs than others; empty: the budget
  std::optional<double> limit, order;  ///< Richardson's, of the finest three rungs; no limit without an order
                                       ///< of convergence (ladder.hpp)
  double known_percent = 0;  ///< 1.25 times the distance of the finest rung from the limit (Roache 1998, 5.9)
  bool meets = false;        ///< its limit lies within Advice::tolerance_percent of the reference
  std::string dissent;  ///< of a consistent method with five rungs: why it speaks against there being a limit
};

struct Choice {
  std::size_t method;          ///< index into Advice::methods
  int divisions;               ///< of the shortest side
  double spacing, cpu, error;  ///< m, s, percent: as predicted
  bool extrapolated;
};

struct Advice {
  double shortest = 0;  ///< m: the shortest side of the bodies that deform
  double spent = 0;     ///< s of CPU
  std::vector<MethodEvidence> methods;
  std::optional<std::size_t> reference;  ///< the method whose limit is best known
  double tolerance_percent = 0, known_percent = 0;
  int meeting = 0;            ///< methods whose limits meet, the reference's own among them
  bool both_kinds = false;    ///< FEM and SPH are among them
  double spread_percent = 0;  ///< how far the limits that meet lie from the reference, at most
  std::string suspect;  ///< why the number may have no limit: on a support of which only a run tells whether
                        ///< it bears anything
  std::vector<std::optional<Choice>> choices;  ///< what each method would need, or reach
  std::vector<std::string> why_not;            ///< of a method without a choice
  std::optional<Choice> best;
  std::string refusal;  ///< why there is no advice
};

/// The four elements, classic (share) and corrected SPH.
std::vector<Method> usual_methods();

/// Runs the ladders. A run that fails is trouble of its method, not an error. Throws std::runtime_error when
/// the scene cannot be asked.
Advice advise(const Scene& scene, const Question& question, const Engine& engine);

/// The advised run, made: its CPU time, its value, and its error against the reference in percent.
struct Outcome {
  double cpu, value, error;
  Price price;
};
Outcome follow(const Scene& scene, const Question& question, const Advice& advice, const Engine& engine);

/// What the command line of `femsph advise` asks of a scene. Throws BadCommand.
struct AdviseCommand;
Question question_of(const AdviseCommand& command, const Scene& scene);

/// For people: ladders, limits, advice.
std::string describe(const Scene& scene, const Question& question, const Advice& advice);
std::string describe(const Advice& advice, const Question& question, const Outcome& outcome);

}  // namespace femsph::compare
