#pragma once
// What several tables of a scene share when they are read: the body and the place that they name, and a
// history in time.
//
// Each function that reads a key adds a fault to the list where the key is missing or wrong, and then returns
// nothing. Each function `.._key(s)` states the keys for the page of keys (femsph help scene).

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/input/toml_fields.hpp"
#include "model/scene/scene.hpp"

namespace femsph::scene_reader {

/// A scene while its file is read.
///
/// After a fault the scene holds stand-ins: a body without a shape, a material with unit values. So a table
/// that refers to them by name is still checked, and no second fault is reported because of the first.
struct Reading {
  Scene& scene;
  Faults& faults;
  std::filesystem::path folder;  ///< of the scene file; relative paths of meshes start here
  int dim = 0;                   ///< 2 or 3; 0 where the key "plane" of [model] is faulty
  bool motion_known = false;     ///< false where the key "motion" of [model] is faulty
  StressReading stress = StressReading::recovered;  ///< default of probes and sections
};

// body.cpp
Key body_key();
/// The body that the table names; the only body of the scene if the table names none.
std::optional<std::size_t> read_body_of(Fields& fields, const Reading& reading);
/// The same, with a fault if that body is rigid; `what` is what a rigid body cannot have ("bars").
std::optional<std::size_t> read_deformable(Fields& fields, const Reading& reading, const char* what);
/// Adds a fault if the body is rigid: it has no nodes or particles. `what` is what the table describes.
void require_deformable(const Fields& fields, const char* what, std::size_t body, const Reading& reading);
/// Adds a fault unless the point (m) lies in the body. A body whose shape is faulty holds every point.
void require_inside(const Fields& fields, const char* key, const Point& point, std::size_t body,
                    const Reading& reading);
std::vector<std::string> body_names(const Scene& scene);
/// Whether the name can be part of a column's or file's name: 1 to 64 letters, digits, _ and -.
bool usable_name(const std::string& name);

// place.cpp
/// The keys body, at, point and within, and after them `more`.
std::vector<Key> place_keys(const std::vector<Key>& more);
std::optional<Place> read_place(Fields& fields, const Reading& reading);

// history.cpp
/// The key "history" of a table, a factor on `what`.
Key history_key(const std::string& what);
/// The keys of that table, whose header is `header`: "[loads.history]".
KeyTable history_keys(const std::string& header, const std::string& what);
/// A step (factor 1 from t = 0) if the key is absent.
std::optional<TimeHistory> read_history(Fields& fields);

}  // namespace femsph::scene_reader
