#include "model/motion/effects/effect.hpp"

#include <algorithm>
#include <limits>

namespace femsph {

double Effect::add_springs(const Motion&, std::size_t, double, AlignedVector<double>&) const {
  return std::numeric_limits<double>::infinity();
}

EffectList::EffectList(Motion& motion) {
  for (const EffectEntry& entry : effects()) {
    if (!entry.make || !(entry.needed ? entry.needed(motion) : entry.on(motion.scene))) continue;
    MadeEffect made = entry.make(motion);
    if (!made.effect) continue;
    all_.push_back(made.effect.get());
    for (std::size_t h = 0; h < with_.size(); ++h)
      if (made.hooks >> h & 1u) with_[h].push_back(made.effect.get());
    own_.push_back(std::move(made.effect));
  }
}

bool EffectList::bodies_may_part() const {
  return std::any_of(
      all_.begin(), all_.end(), [](const Effect* effect) { return effect->bodies_may_part(); });
}

}  // namespace femsph
