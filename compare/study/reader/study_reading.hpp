#pragma once
// The pieces of the study reader: each reads one part of study.toml.

#include <set>

#include "compare/study/reader/study.hpp"
#include "model/input/toml_fields.hpp"

namespace femsph::compare {

/// What a reader of one part needs to know of the rest.
struct StudyReading {
  Study& study;
  Faults& faults;
  std::string default_scene;
  std::set<std::string> bad_scenes{};  ///< files that could not be read, which is said once
  bool runs_known = true;              ///< false: a fault hides which cases and methods there are
  bool quantities_known = true;        ///< false: a fault hides what a quantity is called
};

/// Adds a fault "unknown WHAT NAME; expected ..; did you mean" unless `known` holds the name. When an earlier
/// fault hides what there is (`complete` is false), nothing is said. Returns whether the name is known.
bool require_known(const Fields& fields, const char* key, const std::string& what, const std::string& name,
                   const std::vector<std::string>& known, bool complete);

/// The file of a scene, read on first use; nothing, with a fault at `key`, when it cannot be read.
const Scene* scene_of(const Fields& fields, const char* key, const std::string& file, StudyReading& reading);

void read_runs(Fields& root, StudyReading& reading);  // study_runs.cpp
void read_limit(Fields& root, StudyReading& reading);
void read_repeat(Fields& root, StudyReading& reading);
void read_quantities(Fields& root, StudyReading& reading);  // study_quantities.cpp
void read_series(Fields& root, StudyReading& reading);
void read_paper(Fields& root, StudyReading& reading);  // study_claims.cpp
void read_claims(Fields& root, StudyReading& reading);
void read_bounds(Fields& root, StudyReading& reading);  // study_bounds.cpp: [[bounds]] and [[expectations]]

void read_prices(Fields& root, StudyReading& reading);  // study_prices.cpp
void read_advice(Fields& root, StudyReading& reading);
std::vector<Method> read_methods(Fields& fields, Need need);  // study_runs.cpp

/// "20x2" or "20x2x1". Nothing if it is neither.
std::optional<std::array<int, 3>> parse_divisions(const std::string& text);
/// A list of names known to the study; faults with "did you mean" for the others.
std::vector<std::string> read_names(Fields& fields, const char* key, const std::vector<std::string>& known,
                                    const std::string& what, bool complete);
/// The file of a scene that a run uses, at the key "scene".
std::optional<std::string> read_scene_name(Fields& fields, Need need, const StudyReading& reading);
std::vector<std::string> case_names(const Study& study);
std::vector<std::string> method_labels(const Study& study);
std::vector<std::string> quantity_names(const Study& study);

}  // namespace femsph::compare
