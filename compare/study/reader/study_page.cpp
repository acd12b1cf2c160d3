#include "compare/study/reader/study_page.hpp"

#include "compare/run/plan/method_option.hpp"

namespace femsph::compare {

const KeyPage& study_page() {
  static const KeyPage page = {
      "Keys of a study",
      "Every table and key of a study.toml, written by `femsph help study` from the tables that the reader "
      "itself uses. A quantity is a number with its unit in quotes, such as \"20 mm\". A key is optional "
      "unless it says otherwise. A table applies to the runs, rows or quantities that it names; if it names "
      "none, to all.",
      {study_top_keys(), run_keys(), override_keys(), limit_keys(), scene_limit_keys(), quantity_keys(),
       quantity_along_keys(), paper_keys(), series_keys(), series_along_keys(), price_keys(), advice_keys(),
       claim_keys(), claim_rows_keys(), claim_other_keys(), bound_keys(), expectation_keys()}};
  return page;
}

}  // namespace femsph::compare
