// Any bytes as a scene: a Scene, or an InputError whose every message fits in one paragraph.

#include <cstdlib>

#include "model/motion/effects/catalogue.hpp"
#include "model/scene/reader/reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  try {
    const femsph::Scene scene = femsph::parse_scene(
        std::string(reinterpret_cast<const char*>(data), size), "/nowhere/scene.toml");
    // What runs and tables ask of any scene that was accepted.
    for (const femsph::Body& body : scene.bodies) body.shape->describe();
    for (const femsph::Load& load : scene.loads) load.history.at(0.5 * scene.duration);
    effects_on(scene);
    scene.holds();
  } catch (const femsph::InputError& e) {
    if (e.faults().empty()) std::abort();
  }
  return 0;
}
