#pragma once
// The page of all keys of a study, made of the tables of keys that each reader states.

#include "model/input/keys.hpp"

namespace femsph::compare {

const KeyPage& study_page();

// study_reader.cpp
KeyTable study_top_keys();
// study_runs.cpp
KeyTable run_keys();
// study_limit.cpp
KeyTable limit_keys();
KeyTable scene_limit_keys();
// study_quantities.cpp
KeyTable quantity_keys();
KeyTable quantity_along_keys();
// study_series.cpp
KeyTable series_keys();
KeyTable series_along_keys();
// study_prices.cpp
KeyTable price_keys();
KeyTable advice_keys();
// study_claims.cpp
KeyTable paper_keys();
KeyTable claim_keys();
KeyTable claim_rows_keys();
KeyTable claim_other_keys();
// study_bounds.cpp
KeyTable bound_keys();
KeyTable expectation_keys();

}  // namespace femsph::compare
