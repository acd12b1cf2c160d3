#pragma once
// The catalogue of reductions: what a study can make of a history or of a profile, `reduce = ..`.

#include "compare/measure/curve.hpp"
#include "model/input/keys.hpp"

namespace femsph::compare {

struct Reduction {
  Reduce kind;
  const char* word;
  const char* unit;  ///< SI, of the result; empty: that of what is read
  bool of_section;   ///< of a section, and not of a history ("l2" is of either)
  const char* about;
  double (*of_history)(const Curve&);  ///< null where the curve alone does not give it
};

/// All of them, in the order of the page of keys.
const std::vector<Reduction>& reductions();
const Reduction& reduction_of(Reduce kind);
/// Their words, for Fields::choice.
std::vector<std::pair<std::string, Reduce>> reduction_words();
std::vector<Entry> reduction_entries();

// Those that need more than a curve. All throw std::runtime_error with one sentence.

/// Index of the end of a section, among `points` along it, that is higher (fibre_upper) or lower along y.
std::size_t fibre(const Section& section, std::size_t points, Reduce reduce);
/// M = integral of sigma_xx (y - y0) dA, N m, with y0 the middle of the section, by the trapezoid rule; the
/// width of dA is that of the section's body. The curve is in Pa over m.
double moment(const Curve& curve, const Section& section, const Scene& scene);
/// max(q - (yield + H p))/yield over the samples: q the equivalent stress, p the equivalent plastic strain,
/// of the body that is read.
double excess(const QuantitySpec& quantity, const RunResult& result, const Scene& scene);

}  // namespace femsph::compare
