#pragma once
// What [[quantities]], [[series]] and their "along" have in common: what is read of a run, and the theory
// that it is compared with.

#include "compare/study/reader/study_reading.hpp"

namespace femsph::compare {

/// probe, section, energy, scalar, column, component, unit.
std::vector<Key> observed_keys();
Key theory_key();
Key scene_key(const char* about);
std::vector<Key> joined(std::vector<Key> all, const std::vector<Key>& more);

/// Reads these keys. A probe, section or column must be in every scene of the study, or in `scene` if that is
/// given, and read the same there. `si_of_reduced`: the SI unit of the result, if it is not that of what is
/// read.
Observed read_observed(Fields& fields, const std::optional<std::string>& scene,
                       const std::string& si_of_reduced, const Study& study);

/// A unit of the same kind as `si`; `si` itself where no name is given.
Unit read_unit(Fields& fields, const char* key, const std::optional<std::string>& name,
               const std::string& si);

/// The name of a theory value, in the SI unit `si` (empty: any), which must hold for every scene that it is
/// compared in: a fault otherwise. `over_time`: the theory may depend on time.
std::optional<std::string> read_theory(Fields& fields, const std::optional<std::string>& scene,
                                       const std::string& si, bool over_time, const Study& study);

}  // namespace femsph::compare
