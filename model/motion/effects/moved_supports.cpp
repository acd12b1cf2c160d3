#include <algorithm>

#include "model/motion/effects/catalogue.hpp"

namespace femsph {

EffectEntry moved_supports_effect() {
  EffectEntry e{{"moved supports", "held displacements that follow a velocity in time"}};
  e.asked_by = "[[supports]] velocity";
  e.on = [](const Scene& s) {
    return std::any_of(s.supports.begin(), s.supports.end(),
                       [](const Support& support) { return support.velocity != Point{}; });
  };
  e.outside = true;
  e.rank_off = 0;
  return e;
}

}  // namespace femsph
