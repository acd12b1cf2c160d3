#pragma once
// Scenes of bodies that touch.

#include <string>

#include "support.hpp"

namespace femsph::test {

inline const char* const both[] = {"fem-full", "sph-corrected"};

/// Steel bodies in plane stress; `rest` holds the bodies and what follows.
inline Scene steel_bodies(const std::string& rest, const char* poisson = "0.0", bool large = false) {
  using namespace scene_text;
  return parse_scene(model("stress", large ? large_motion : "") + steel(poisson) + rest, "contact.toml");
}

/// 10 mm thick.
inline std::string block(const char* name, const char* origin, const char* size) {
  return scene_text::box(name, size, scene_text::origin(origin) + scene_text::thick("10 mm"));
}
inline std::string rigid_block(const char* name, const char* origin, const char* size,
                               const std::string& mass) {
  return fmt::format("[bodies.{}]\nshape = \"box\"\nsize = {}\n", name, scene_text::list(size)) +
         scene_text::origin(origin) + scene_text::rigid(mass);
}
inline std::string moving(const char* name, const char* velocity) {
  return scene_text::initial(velocity, scene_text::of_body(name));
}
inline std::string held(const char* name) {
  return fmt::format("[[supports]]\nbody = \"{}\"\nfix = [\"x\", \"y\", \"turn\"]\n", name);
}
inline std::string touching(const char* a, const char* b, double friction = 0) {
  return scene_text::contact(
      a, b, scene_text::named("impact") + fmt::format("friction = {:.9f}\n", friction));
}
inline std::string lasting(double seconds, int samples = 400) {
  return scene_text::time(fmt::format("{:.9g} s", seconds), fmt::format("samples = {}\n", samples));
}

}  // namespace femsph::test
