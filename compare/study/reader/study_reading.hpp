#pragma once
// The parts of the study reader: each reads some tables of study.toml.

#include <set>

#include "compare/study/reader/study.hpp"
#include "model/input/toml_fields.hpp"

namespace femsph::compare {

/// What the readers of the parts share.
struct StudyReading {
  Study& study;
  Faults& faults;
  std::string default_scene;
  std::set<std::string> bad_scenes{};  ///< files that could not be read: reported once
  bool runs_known = true;              ///< false: after a fault, cases and methods are not known
  bool limits_known = true;            ///< false: [limit] or [[limits]] is misspelt
  bool quantities_known = true;        ///< false: after a fault, the names of quantities are not known
};

/// Adds a fault "unknown WHAT NAME; expected ..; did you mean" unless `known` holds the name. With `complete`
/// false, when an earlier fault hides some names, adds no fault. Returns whether the name is known.
bool require_known(const Fields& fields, const char* key, const std::string& what, const std::string& name,
                   const std::vector<std::string>& known, bool complete);

/// The file of a scene, read on first use; nothing, with a fault at `key`, when it cannot be read.
const Scene* scene_of(const Fields& fields, const char* key, const std::string& file, StudyReading& reading);

void read_runs(Fields& root, StudyReading& reading);  // study_runs.cpp
void read_repeat(Fields& root, StudyReading& reading);
void read_limit(Fields& root, StudyReading& reading);       // study_limit.cpp
void read_quantities(Fields& root, StudyReading& reading);  // study_quantities.cpp
void read_series(Fields& root, StudyReading& reading);      // study_series.cpp
void read_paper(Fields& root, StudyReading& reading);       // study_claims.cpp
void read_claims(Fields& root, StudyReading& reading);
void read_bounds(Fields& root, StudyReading& reading);  // study_bounds.cpp: [[bounds]] and [[expectations]]

void read_prices(Fields& root, StudyReading& reading);  // study_prices.cpp
void read_advice(Fields& root, StudyReading& reading);
/// The methods at the key "methods"; `scene`: what their bodies are checked against, null if it is not known.
std::vector<BodyMethods> read_methods(Fields& fields, Need need, const Scene* scene);  // study_runs.cpp

/// Cells along the axes from "20x2" or "20x2x1". Nothing if it is neither.
std::optional<std::array<int, 3>> parse_divisions(const std::string& text);
/// A list of names known to the study; faults with "did you mean" for the others.
std::vector<std::string> read_names(Fields& fields, const char* key, const std::vector<std::string>& known,
                                    const std::string& what, bool complete);
/// The file of a scene that a run uses, at the key "scene".
std::optional<std::string> read_scene_name(Fields& fields, Need need, const StudyReading& reading);
/// Letters, digits, _ and -, and the characters of `also`: fit for a file's name.
bool is_file_name(const std::string& text, const std::string& also = "");
std::vector<std::string> case_names(const Study& study);
std::vector<std::string> method_labels(const Study& study);
std::vector<std::string> quantity_names(const Study& study);

}  // namespace femsph::compare
