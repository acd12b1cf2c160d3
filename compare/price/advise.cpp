#include "compare/price/advise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/measure/ladder.hpp"
#include "compare/measure/reduce.hpp"

namespace femsph::compare {
namespace {

// Divisions of the shortest side. Their ratios are 1.3 to 2: the finest run costs more than all others.
constexpr int ladder_divisions[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512};

double shortest_side(const Scene& scene) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Body& body : scene.bodies) {
    if (body.rigid) continue;
    for (int a = 0; a < scene.dim(); ++a)
      shortest = std::min(shortest, body.shape->upper()[a] - body.shape->lower()[a]);
  }
  if (!std::isfinite(shortest) || !(shortest > 0))
    throw Refusal("no body deforms: there is nothing to discretize");
  return shortest;
}

struct Ladders {
  const Scene& scene;
  const Question& question;
  const Engine& engine;
  Advice& advice;

  RunOptions options() const {
    RunOptions o;
    o.march.safety = question.safety;
    return o;
  }

  double cost_of_next(const MethodEvidence& m, int divisions) const {
    if (m.rungs.empty()) return 0;
    return PricedLadder(m.rungs, scene.dim()).cpu_at(advice.shortest / divisions);
  }

  /// Whether an error is asked for and the limit is known to a fifth of it. The error of the finest run is
  /// then smaller than the one asked for.
  bool knows_enough(const MethodEvidence& m) const {
    if (!question.error || m.rungs.size() < 4) return false;
    Ladder values;
    for (std::size_t i = 0; i < m.rungs.size(); ++i) values.push_back({m.rungs[i].spacing, m.values[i]});
    const auto found = richardson(values);
    return found && found->limit != 0 && is_convergence(found->order) &&
           125 * std::abs(m.values.back() / found->limit - 1) < 0.2 * *question.error;
  }

  /// Adds a rung. A short run is made twice: the smaller of two times has less disturbance in it.
  void climb(MethodEvidence& m, int divisions) {
    RunResult r;
    double cpu = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < 2 && (turn == 0 || cpu < 0.3); ++turn) {
      r = engine.run(scene, m.method, Resolution{advice.shortest / divisions, {}}, options());
      cpu = std::min(cpu, r.price.total_cpu);
      advice.spent += r.price.total_cpu;
    }
    if (scene.settling && !r.settled)
      throw std::runtime_error("it did not settle within the scene's duration");
    if (!m.rungs.empty() && double(r.price.units) == m.rungs.back().units)
      throw std::runtime_error("its cells are those of the mesh file, whatever the spacing");
    const double value = reduce(question.quantity, r, scene, nullptr).value;
    PricedRung rung{advice.shortest / divisions, 0, cpu};
    rung.steps = double(r.price.steps), rung.units = double(r.price.units),
    rung.dof = double(r.points) * scene.dim();
    m.rungs.push_back(rung);
    m.values.push_back(value);
    m.divisions.push_back(divisions);
  }

  void run() {
    std::vector<bool> active(question.methods.size(), true);
    for (const BodyMethods& method : question.methods)
      advice.methods.push_back({method, {}, {}, {}, "", {}, {}, 0, false, {}});
    for (const int divisions : ladder_divisions) {
      for (std::size_t k = 0; k < advice.methods.size(); ++k) {
        if (!active[k]) continue;
        MethodEvidence& m = advice.methods[k];
        const double share = (question.budget - advice.spent) /
                             double(std::count(active.begin(), active.end(), true));
        if (knows_enough(m) || advice.spent >= question.budget || cost_of_next(m, divisions) > share) {
          active[k] = false;
          continue;
        }
        try {
          climb(m, divisions);
          m.trouble.clear();
        } catch (const std::exception& e) {  // a coarse run may fail where a finer one does not
          m.trouble = e.what();
          if (!m.rungs.empty() || divisions >= 8) active[k] = false;
        }
      }
    }
  }
};

void find_limits(Advice& advice) {
  for (MethodEvidence& m : advice.methods) {
    Ladder values;
    for (std::size_t i = 0; i < m.rungs.size(); ++i) values.push_back({m.rungs[i].spacing, m.values[i]});
    const auto found = richardson(values);
    if (!found || found->limit == 0) continue;
    m.limit = found->limit, m.order = found->order;
    m.known_percent = 125 * std::abs(m.values.back() / found->limit - 1);
    if (!is_convergence(found->order)) m.limit.reset();
  }
}

/// A consistent method converges if there is a limit. Classic SPH is not consistent: its errors at a boundary
/// do not vanish.
bool consistent(const BodyMethods& methods) {
  return std::all_of(methods.entries.begin(), methods.entries.end(), [](const BodyMethod& entry) {
    const auto* sph = std::get_if<sph::Options>(&entry.method.options);
    return !sph || sph::formulation_named(sph->formulation).corrected;
  });
}

/// Finds ladders of five rungs or more whose values do not converge: they change in one direction, without an
/// order of convergence, by amounts that matter for the answer. A displacement under a point force does so,
/// as it grows like a logarithm.
void find_dissent(Advice& advice) {
  for (MethodEvidence& m : advice.methods) {
    const std::size_t n = m.values.size();
    if (!consistent(m.method) || n < 5) continue;
    const double before = m.values[n - 2] - m.values[n - 3], last = m.values[n - 1] - m.values[n - 2];
    const bool on = before * last > 0,
               matters = 100 * std::abs(last) >= 0.2 * advice.tolerance_percent * std::abs(m.values[n - 1]);
    if (!on || !matters || (m.order && *m.order >= least_order)) continue;
    m.dissent = fmt::format(
        "the values of {} keep changing from spacing to spacing ({}), so that they do not converge",
        m.method.name, m.order ? fmt::format("order {:.2f}", *m.order) : "by more each time");
  }
}

/// Whether a body has the same method in both, so that they agree without confirming each other.
bool share_a_method(const BodyMethods& a, const BodyMethods& b, const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [&](const Body& body) { return !body.rigid && a.of(body).name == b.of(body).name; });
}

/// The reference is the best-known limit among those that other methods agree with; if there is none, the
/// best-known limit.
void find_reference(const Scene& scene, Advice& advice) {
  const auto meets = [&](const MethodEvidence& a, const MethodEvidence& b) {
    return a.limit && b.limit && 100 * std::abs(*a.limit / *b.limit - 1) <= advice.tolerance_percent;
  };
  const auto confirms = [&](const MethodEvidence& a, const MethodEvidence& b) {
    return meets(a, b) && !share_a_method(a.method, b.method, scene);
  };
  int most = 0;
  for (std::size_t k = 0; k < advice.methods.size(); ++k) {
    const MethodEvidence& m = advice.methods[k];
    if (!m.limit) continue;
    const int others = int(std::count_if(advice.methods.begin(), advice.methods.end(),
                                         [&](const MethodEvidence& o) { return confirms(o, m); }));
    const bool better = !advice.reference || std::min(others, 1) > std::min(most, 1) ||
                        (std::min(others, 1) == std::min(most, 1) &&
                         m.known_percent < advice.methods[*advice.reference].known_percent);
    if (better) advice.reference = k, most = others;
  }
  if (!advice.reference) return;
  const MethodEvidence& reference = advice.methods[*advice.reference];
  bool fem = false, sph = false;
  for (MethodEvidence& m : advice.methods) {
    m.meets = meets(m, reference);
    for (std::size_t i = 0; i < m.rungs.size(); ++i)
      m.rungs[i].error = 100 * (m.values[i] / *reference.limit - 1);
    if (&m != &reference && !confirms(m, reference)) continue;
    advice.spread_percent = std::max(advice.spread_percent, 100 * std::abs(*m.limit / *reference.limit - 1));
    ++advice.meeting;
    fem = fem || m.method.all_fem(), sph = sph || m.method.all_sph();
  }
  advice.both_kinds = fem && sph;
  advice.known_percent = reference.known_percent;
}

/// The spacing that a method needs for nine tenths of the error, rounded to whole divisions of the shortest
/// side.
std::optional<Choice> for_error(const Advice& advice, std::size_t k, double error, const PricedLadder& ladder,
                                std::string& why) {
  const auto cost = ladder.cost_of(0.9 * error);
  if (!cost.reached()) {
    why = cost.reason;
    return {};
  }
  const int divisions = int(std::ceil(advice.shortest / cost.spacing - 1e-6));
  const double spacing = advice.shortest / divisions;
  const double expected = ladder.error_at(spacing).value_or(0.9 * error);
  const bool extrapolated = spacing < ladder.rungs().back().spacing * (1 - 1e-9);
  return Choice{k, divisions, spacing, ladder.cpu_at(spacing), expected, extrapolated};
}

/// The smallest error that a method reaches in the time.
std::optional<Choice> for_time(const Advice& advice, std::size_t k, double within, const PricedLadder& ladder,
                               std::string& why) {
  const auto spacing = ladder.spacing_for(within);
  if (!spacing) {
    why = "even the coarsest run takes longer";
    return {};
  }
  const int most = int(std::floor(furthest * double(advice.methods[k].divisions.back()) + 1e-6));
  int divisions = std::min(int(std::floor(advice.shortest / *spacing + 1e-6)), most);
  if (ladder.error_at(advice.shortest / divisions, &why)) {
    const double d = advice.shortest / divisions;
    const bool extrapolated = d < ladder.rungs().back().spacing * (1 - 1e-9);
    return Choice{k, divisions, d, ladder.cpu_at(d), *ladder.error_at(d), extrapolated};
  }
  divisions = std::min(divisions, advice.methods[k].divisions.back());  // not finer than what was measured
  const double d = advice.shortest / divisions;
  return Choice{
      k, divisions, d, ladder.cpu_at(d), ladder.error_at(d).value_or(ladder.credited().back()), false};
}

void choose(const Scene& scene, const Question& question, Advice& advice) {
  advice.choices.resize(advice.methods.size());
  advice.why_not.resize(advice.methods.size());
  for (std::size_t k = 0; k < advice.methods.size(); ++k) {
    const MethodEvidence& m = advice.methods[k];
    std::string& why = advice.why_not[k];
    if (m.rungs.size() < 2) {
      why = m.trouble.empty() ? "fewer than two runs within the budget" : m.trouble;
      continue;
    }
    const PricedLadder ladder(m.rungs, scene.dim(), advice.known_percent);
    advice.choices[k] = question.error ? for_error(advice, k, *question.error, ladder, why)
                                       : for_time(advice, k, *question.within, ladder, why);
    const auto& choice = advice.choices[k];
    if (!choice) continue;
    const auto rank = [&](const Choice& c) {
      return question.error ? std::pair(c.cpu, c.error)
                            : std::pair(std::max(c.error, advice.known_percent), c.cpu);
    };
    if (!advice.best || rank(*choice) < rank(*advice.best)) advice.best = choice;
  }
}

}  // namespace

std::vector<BodyMethods> usual_methods() {
  std::vector<BodyMethods> all;
  for (const char* name :
       {"fem-full", "fem-sri", "fem-one-point", "fem-assumed-strain", "sph-classic-share", "sph-corrected"})
    all.push_back(method_named(name));
  return all;
}

Advice advise(const Scene& scene, const Question& question, const Engine& engine) {
  Advice advice;
  advice.shortest = shortest_side(scene);
  advice.tolerance_percent = question.error ? std::max(0.5 * *question.error, 0.02) : 0.5;
  advice.refusal = no_value_at(question.quantity, scene);
  if (!advice.refusal.empty()) return advice;
  advice.suspect = no_value_at(question.quantity, scene, false);
  Ladders{scene, question, engine, advice}.run();
  find_limits(advice);
  find_dissent(advice);
  find_reference(scene, advice);
  const auto dissent = std::find_if(advice.methods.begin(), advice.methods.end(),
                                    [](const MethodEvidence& m) { return !m.dissent.empty(); });
  if (dissent != advice.methods.end())
    advice.refusal = dissent->dissent + ": there may be no limit" +
                     (advice.suspect.empty() ? "" : "; " + advice.suspect);
  else if (!advice.reference)
    advice.refusal = "no method's values approach a limit; a larger --budget allows finer runs";
  else if (advice.meeting < 2)
    advice.refusal =
        "no two methods approach the same limit, so that it is not known which is right; a larger --budget "
        "allows finer runs";
  else
    choose(scene, question, advice);
  if (advice.refusal.empty() && !advice.best)
    advice.refusal = question.error
                         ? "no method can be shown to reach this error; a larger --budget allows finer runs"
                         : "no method runs in this time";
  return advice;
}

Outcome follow(const Scene& scene, const Question& question, const Advice& advice, const Engine& engine) {
  const Choice& best = advice.best.value();
  RunOptions options;
  options.march.safety = question.safety;
  const RunResult r = engine.run(
      scene, advice.methods[best.method].method, Resolution{best.spacing, {}}, options);
  const double value = reduce(question.quantity, r, scene, nullptr).value,
               limit = *advice.methods[*advice.reference].limit;
  return {r.price.total_cpu, value, 100 * (value / limit - 1), r.price};
}

}  // namespace femsph::compare
