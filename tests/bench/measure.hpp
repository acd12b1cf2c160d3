#pragma once
// What the bench measures. Times are CPU seconds unless stated otherwise.

#include <benchmark/benchmark.h>

#include "tests/bench/cases.hpp"

namespace femsph::bench {

/// One step of a motion that is prescribed: internal force (gradient, law, divergence), kick and drift.
/// Counters: units; bytes, held for a unit; force, s of the step that the internal force takes; yielding,
/// share of the points that yield in a step.
void step(benchmark::State& state, const Case& c, bool oracle = false);

/// Wall time of a step on one thread over that on two, measured in turns, the best of each.
void two_threads(benchmark::State& state, const Case& c);

/// A step of the whole march, with everything that the scene asks for, without set-up.
void march_step(benchmark::State& state, const Case& c);

/// a = b + s c, the triad: the speed of the memory.
void triad(benchmark::State& state, std::size_t n);

}  // namespace femsph::bench
