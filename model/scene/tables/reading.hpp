#pragma once
// The parts of the reader of scenes; only reader*.cpp include this.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/input/toml_fields.hpp"
#include "model/scene/scene.hpp"

namespace femsph::scene_reader {

/// What the parts share while one file is read. After a fault the scene holds stand-ins (a body without a
/// shape, a material with unit values), so that whatever refers to them by name is still checked and not
/// reported for their sake.
struct Reading {
  Scene& scene;
  Faults& faults;
  std::filesystem::path folder;                     ///< of the file: mesh paths start here
  int dim = 0;                                      ///< 0: the plane of the scene is itself at fault
  bool motion_known = false;                        ///< false: "motion" of the scene is itself at fault
  StressReading stress = StressReading::recovered;  ///< of probes and sections that do not say
};

void read_model(Fields& root, Reading& reading);
void read_materials(Fields& root, Reading& reading);
void read_bodies(Fields& root, Reading& reading);
void read_supports(Fields& root, Reading& reading);
void read_symmetries(Fields& root, Reading& reading);
void read_bars(Fields& root, Reading& reading);
void read_loads(Fields& root, Reading& reading);
void read_initial_velocities(Fields& root, Reading& reading);
void read_initial_displacements(Fields& root, Reading& reading);
void read_contacts(Fields& root, Reading& reading);
void read_gravity(Fields& root, Reading& reading);
void read_damping(Fields& root, Reading& reading);
void read_output(Fields& root, Reading& reading);
void read_probes(Fields& root, Reading& reading);
void read_sections(Fields& root, Reading& reading);
void read_time(Fields& root, Reading& reading);
void read_settling(Fields& root, Reading& reading);
/// The tables of effects that read their own (EffectEntry::read).
void read_effects(Fields& root, Reading& reading);

/// What is left of [bodies.NAME] for a body that is rigid: its mass.
void read_rigid_body(Fields& fields, Body& body, const Reading& reading);
/// fix = ["x", "turn"] of a support of a rigid body.
void read_rigid_support(Fields& fields, const Place& place, Reading& reading);
/// Adds a fault if the body is rigid: it has no points of its own.
void require_deformable(const Fields& fields, const char* what, std::size_t body, const Reading& reading);
std::vector<std::string> body_names(const Scene& scene);
/// Short, and made of letters, digits, _ and -: good for a column or a file.
bool usable_name(const std::string& name);

/// The body that a table names; the only body if it names none.
std::optional<std::size_t> read_body_of(Fields& fields, const Reading& reading);
/// body, and at or point.
std::optional<Place> read_place(Fields& fields, const Reading& reading);
/// Adds a fault unless the point lies in the body (or the body's shape is unknown after a fault of its own).
void require_inside(const Fields& fields, const char* key, const Point& point, std::size_t body,
                    const Reading& reading);
/// Points this near to a shape count as on it, m: far above rounding, far below any spacing.
double point_tolerance(const Shape& shape);

}  // namespace femsph::scene_reader
