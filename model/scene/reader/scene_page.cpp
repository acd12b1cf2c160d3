#include "model/scene/reader/scene_page.hpp"

#include <algorithm>

#include "model/motion/effects/catalogue.hpp"

namespace femsph {

const KeyPage& scene_page() {
  using namespace scene_reader;
  static const KeyPage page = [] {
    KeyPage page = {
        "Keys of a scene",
        "Every table and key of a scene file, written by `femsph help scene` from the tables that the reader "
        "itself uses. A quantity is a number with its unit in quotes, such as \"1000 mm\" or \"25 kN\"; any "
        "unit of the same kind will do. A vector has two components in a plane scene and three in space; a "
        "matrix has as many rows, each of as many entries. A key is optional unless it says otherwise.",
        {top_keys(), model_keys(), material_keys()}};
    const auto append = [&](const std::vector<KeyTable>& more) {
      page.tables.insert(page.tables.end(), more.begin(), more.end());
    };
    append(law_tables());
    append({body_keys()});
    for (const EffectEntry& effect : effects()) append(effect.tables);
    append({output_keys(), probe_keys(), section_keys(), time_keys()});
    return page;
  }();
  return page;
}

}  // namespace femsph
