#include "model/motion/effects/catalogue.hpp"

namespace femsph {

EffectEntry loads_effect() {
  EffectEntry e{{"loads", "forces on a place, or a pressure on a side, that follow a history in time"}};
  e.asked_by = "[[loads]]";
  e.on = [](const Scene& s) { return !s.loads.empty(); };
  e.outside = true;
  e.rank_off = 0;
  return e;
}

}  // namespace femsph
