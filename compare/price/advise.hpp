#pragma once
// Advice on a method and a spacing, from runs of the scene by each method at a few spacings, from coarse to
// fine (a ladder; each run is a rung).

#include "compare/price/priced_ladder.hpp"
#include "compare/study/study_runner.hpp"

namespace femsph::compare {

struct Question {
  QuantitySpec quantity;  ///< the number whose error counts; its theory and reference are ignored
  std::vector<BodyMethods> methods;
  std::optional<double> error;   ///< percent: the least time for this error
  std::optional<double> within;  ///< s of CPU: the least error in this time
  double budget = 30;            ///< s of CPU for all ladders together
  double safety = 0.98;
};

/// The runs of one method, and what they show.
struct MethodEvidence {
  BodyMethods method;
  std::vector<int> divisions;     ///< of the shortest side; one for each rung
  std::vector<PricedRung> rungs;  ///< their errors are set once there is a reference
  std::vector<double> values;
  std::string trouble;                 ///< why its last run failed; empty if it did not
  std::optional<double> limit, order;  ///< Richardson's, of the finest three rungs; no limit without an order
                                       ///< of convergence (ladder.hpp)
  double known_percent = 0;  ///< 1.25 times the distance of the finest rung from the limit (Roache 1998, 5.9)
  bool meets = false;        ///< its limit lies within Advice::tolerance_percent of the reference
  std::string dissent;  ///< of a consistent method with five rungs or more: why its values do not converge
};

struct Choice {
  std::size_t method;          ///< index into Advice::methods
  int divisions;               ///< of the shortest side
  double spacing, cpu, error;  ///< m, s, percent; predicted
  bool extrapolated;
};

struct Advice {
  double shortest = 0;  ///< m: the shortest side of the bodies that deform
  double spent = 0;     ///< s of CPU
  std::vector<MethodEvidence> methods;
  std::optional<std::size_t> reference;  ///< index of the method whose limit is the reference
  double tolerance_percent = 0, known_percent = 0;
  int meeting = 0;            ///< number of methods whose limits agree, with the reference method; without
                              ///< those that share the method of a body with it
  bool both_kinds = false;    ///< FEM and SPH are among them
  double spread_percent = 0;  ///< largest distance of these limits from the reference
  std::string suspect;  ///< why the exact value may be infinite: at a support that may or may not carry a
                        ///< reaction
  std::vector<std::optional<Choice>>
      choices;                       ///< what each method needs for the error, or reaches in the time
  std::vector<std::string> why_not;  ///< why a method has no choice
  std::optional<Choice> best;
  std::string refusal;  ///< why there is no advice
};

/// The four elements, classic (share) and corrected SPH.
std::vector<BodyMethods> usual_methods();

/// Runs the ladders. A run that fails is noted with its method. Throws Refusal if no body deforms.
Advice advise(const Scene& scene, const Question& question, const Engine& engine);

/// The advised run: CPU time in s, value in the unit of the quantity, error against the reference in percent.
struct Outcome {
  double cpu, value, error;
  Price price;
};
Outcome follow(const Scene& scene, const Question& question, const Advice& advice, const Engine& engine);

/// The question of a command line of `femsph advise`. Throws BadCommand.
struct AdviseCommand;
Question question_of(const AdviseCommand& command, const Scene& scene);

/// The advice as text: ladders, limits, advice.
std::string describe(const Scene& scene, const Question& question, const Advice& advice);
std::string describe(const Advice& advice, const Question& question, const Outcome& outcome);

}  // namespace femsph::compare
