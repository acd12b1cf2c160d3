// The keys of what acts on bodies: supports, loads, starts, contacts, gravity, damping, settling.

#include "model/motion/effects/catalogue.hpp"
#include "model/scene/reader/scene_page.hpp"

namespace femsph::scene_reader {
namespace {

const std::string length = key_holds::vector(dimension::length);

KeyTable history_keys(const std::string& header, const std::string& what) {
  return {
      header,
      "How " + what + " grows in time, inline: history = {ramp = \"1 ms\"} or {time = [..], factor = [..]}.",
      {{"ramp", key_holds::quantity(dimension::time), "The factor grows from 0 to 1 over this time.", false,
        "unless \"time\" and \"factor\" are given"},
       {"time", key_holds::quantities(dimension::time), "Increasing times.", false, "with \"factor\""},
       {"factor", key_holds::numbers,
        "A factor for each time: linear between, and held constant before the first and after the last.",
        false, "with \"time\""}}};
}

Key history_key(const std::string& what) {
  return {"history", "a text or a table", "\"step\" (unless given), or a factor on " + what + " over time."};
}

std::vector<Key> with_place(std::vector<Key> own) {
  std::vector<Key> all = place_keys();
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

}  // namespace

KeyTable support_keys() {
  return {
      "[[supports]]", "Holds displacement components of a place where they are at the start, or moves them.",
      with_place({{"fix", key_holds::texts,
                   "The components held: \"x\", \"y\", \"z\". Of a rigid body also \"turn\" in a plane, "
                   "\"turn-x\", \"turn-y\", \"turn-z\" in space.",
                   true},
                  {"mode", key_holds::words(std::vector<std::string>{"each", "mean"}),
                   "\"each\" (unless given) holds every point of the place, \"mean\" only their weighted "
                   "mean, so that the place may turn."},
                  {"velocity", key_holds::vector(dimension::velocity),
                   "The held components move with it; the others are 0."},
                  history_key("the velocity"),
                  {"name", key_holds::text,
                   "Puts the reaction into the history: support_NAME_force_x, .., support_NAME_moment_z, "
                   "support_NAME_centroid_x, .."}})};
}

KeyTable support_history_keys() { return history_keys("[supports.history]", "a support's velocity"); }

KeyTable load_keys() {
  return {"[[loads]]", "A force on a place, or a pressure on a side.",
          with_place({{"force", key_holds::vector(dimension::force), "The total over the place.", false,
                       "unless \"pressure\" is given"},
                      {"pressure", key_holds::quantity(dimension::pressure),
                       "Inward, on the undeformed boundary of one side; small motion only."},
                      history_key("the load")})};
}

KeyTable load_history_keys() { return history_keys("[loads.history]", "a load"); }

KeyTable initial_keys() {
  return {"[[initial]]",
          "A velocity at the start, s(X) (velocity + spin x (X - centre) + gradient (X - centre)); tables of "
          "one body add up.",
          {body_key(),
           {"velocity", key_holds::vector(dimension::velocity), "The same everywhere. 0 unless given."},
           {"spin",
            key_holds::vector(dimension::rotation) + "; in a plane scene only " +
                key_holds::quantity(dimension::rotation) + ", about z",
            "0 unless given."},
           {"gradient", key_holds::matrix(&dimension::rate), "Rows dv_x/dX, dv_x/dY, .. 0 unless given."},
           {"centre", length, "Of spin and gradient. The origin unless given."}}};
}

KeyTable profile_keys() {
  return {
      "[initial.profile]",
      "A wave over the body, inline: profile = {axis = \"y\", wavelength = \"24 m\"} is s(X) = sin(2 pi (Y - "
      "origin) / wavelength). Without it s = 1.",
      {{"axis", key_holds::words(std::vector<std::string>{"x", "y", "z"}), "The axis along which it varies.",
        true},
       {"wavelength", key_holds::quantity(dimension::length), "Of the sine.", true},
       {"origin", key_holds::quantity(dimension::length), "Where the sine is zero. 0 unless given."}}};
}

KeyTable initial_displacement_keys() {
  return {"[[initial_displacements]]",
          "A displacement at the start, u = gradient (X - centre); one table a body.",
          {body_key(),
           {"gradient", key_holds::matrix(nullptr), "Rows du_x/dX, du_x/dY, ..", true},
           {"centre", length, "Where it is zero. The origin unless given."}}};
}

KeyTable contact_keys() {
  return {"[[contacts]]",
          "Two bodies that press on each other where they touch, or that are bonded there.",
          {{"between", key_holds::texts, "The names of the two bodies.", true},
           {"kind", key_holds::words(std::vector<std::string>{"press", "tied"}),
            "\"press\" (unless given), or \"tied\": bonded where they touch at the start."},
           {"stiffness", key_holds::number, "A factor above 0 on the default penalty. 1 unless given."},
           {"friction", key_holds::number, "Coulomb's coefficient. 0 unless given."},
           {"name", key_holds::text, "In columns: contact_NAME_force_x, .. BODY1-BODY2 unless given."}}};
}

KeyTable gravity_keys() {
  return {"[gravity]",
          "The same acceleration on all bodies.",
          {{"acceleration", key_holds::vector(dimension::acceleration),
            "Such as [\"0 m/s^2\", \"-9.81 m/s^2\"].", true}}};
}

KeyTable damping_keys() {
  return {"[damping]",
          "A force -c m v on every point.",
          {{"rate", key_holds::quantity(dimension::rate), "c, the rate of decay of a free velocity.", true}}};
}

KeyTable settling_keys() {
  return {"[settling]",
          "Asks for the static state: the march ends when the motion has died out.",
          {{"method", key_holds::words(std::vector<std::string>{"damping", "kinetic"}),
            "\"damping\": in proportion to the mass; \"kinetic\": all velocities are set to zero at every "
            "peak of the kinetic energy.",
            true},
           {"tolerance", key_holds::number,
            "Settled when the amplitude of what still moves is below this share of the displacement, 0 to 1. "
            "1e-4 unless given."},
           {"rate", key_holds::quantity(dimension::rate),
            "c of \"damping\". Twice the lowest angular frequency, estimated on the way, unless given."}}};
}

std::vector<KeyTable> effect_tables() {
  std::vector<KeyTable> all;
  for (const EffectEntry& effect : effects())
    if (!effect.table.empty()) all.push_back({"[" + effect.table + "]", effect.about, effect.keys});
  return all;
}

}  // namespace femsph::scene_reader
