// Coulomb friction. Its key is one of [[contacts]] (contact.cpp), its work is in contact_pair.cpp.

#include <algorithm>

#include "model/motion/effects/catalogue.hpp"

namespace femsph {

EffectEntry friction_effect() {
  EffectEntry e{{"friction", "Coulomb friction between bodies in contact"}};
  e.asked_by = "[[contacts]] friction";
  e.on = [](const Scene& s) {
    return std::any_of(s.contacts.begin(), s.contacts.end(), [](const Contact& c) { return c.friction > 0; });
  };
  e.listed_off = false;
  return e;
}

}  // namespace femsph
