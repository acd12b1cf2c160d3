#include "model/scene/reader/scene_page.hpp"

#include <algorithm>

namespace femsph {

const KeyPage& scene_page() {
  using namespace scene_reader;
  static const KeyPage page = [] {
    KeyPage page = {
        "Keys of a scene",
        "Every table and key of a scene file, written by `femsph help scene` from the tables that the reader "
        "itself uses. A quantity is a number with its unit in quotes, such as \"1000 mm\" or \"25 kN\"; any "
        "unit of the same kind will do. A vector has two components in a plane scene and three in space; a "
        "matrix as many rows of as many entries. A key is optional unless it says otherwise.",
        {top_keys(),
         model_keys(),
         material_keys(),
         body_keys(),
         symmetry_keys(),
         bar_keys(),
         support_keys(),
         support_history_keys(),
         load_keys(),
         load_history_keys(),
         initial_keys(),
         profile_keys(),
         initial_displacement_keys(),
         contact_keys(),
         gravity_keys(),
         damping_keys(),
         output_keys(),
         probe_keys(),
         section_keys(),
         time_keys(),
         settling_keys()}};
    const auto insert_after = [&](const std::string& path, const std::vector<KeyTable>& more) {
      const auto at = std::find_if(page.tables.begin(), page.tables.end(), [&](const KeyTable& table) {
        return table.path() == path;
      });
      page.tables.insert(at + 1, more.begin(), more.end());
    };
    insert_after("materials.NAME", law_tables());
    insert_after("damping", effect_tables());
    return page;
  }();
  return page;
}

}  // namespace femsph
