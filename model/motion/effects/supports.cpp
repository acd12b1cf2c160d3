#include "model/motion/effects/catalogue.hpp"

namespace femsph {

EffectEntry supports_effect() {
  EffectEntry e{{"supports", "displacements held where they start, or their mean over a place"}};
  e.asked_by = "[[supports]]";
  e.on = [](const Scene& s) { return !s.supports.empty(); };
  e.outside = true;
  e.rank_off = 0;
  return e;
}

}  // namespace femsph
