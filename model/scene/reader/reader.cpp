#include "model/scene/reader/reader.hpp"

#include "model/scene/reader/scene_reader.hpp"
#include "model/scene/singular.hpp"

namespace femsph {
namespace scene_reader {

void read_model(Fields& root, Reading& reading) {
  auto model = root.table("model", Need::required, "a table with plane = \"stress\", \"strain\" or \"none\"");
  if (!model) return;
  const auto plane = model->choice<Plane>(
      "plane", Need::required, {{"stress", Plane::stress}, {"strain", Plane::strain}, {"none", Plane::none}});
  const auto large = model->choice<bool>("motion", Need::optional, {{"small", false}, {"large", true}});
  model->done();
  reading.scene.plane = plane.value_or(Plane::stress);
  reading.scene.large_motion = large.value_or(false);
  if (plane) reading.dim = reading.scene.dim();
  reading.motion_known = large || !model->has("motion");
}

void read_time(Fields& root, Reading& reading) {
  auto time = root.table("time", Need::required, "a table with duration = \"50 ms\" or the like");
  if (!time) return;
  Scene& scene = reading.scene;
  scene.duration = time->quantity("duration", Need::required, dimension::time, Sign::positive).value_or(0);
  scene.samples = time->count("samples", Need::optional, 1, 10'000'000).value_or(scene.samples);
  scene.snapshots = time->count("snapshots", Need::optional, 0, 1'000'000).value_or(scene.snapshots);
  time->done();
}

}  // namespace scene_reader

Scene parse_scene(const std::string& text, const std::string& file) {
  using namespace scene_reader;
  const toml::table table = parse_toml(text, file);
  Scene scene;
  Faults faults;
  Fields root(table, "", faults);
  Reading reading{scene, faults, std::filesystem::path(file).parent_path()};

  scene.file = file;
  scene.text = text;
  scene.title = root.text("title", Need::optional).value_or("");
  read_model(root, reading);  // first: it says how many components a vector has
  read_materials(root, reading);
  read_bodies(root, reading);  // before all that refers to a body
  read_supports(root, reading);
  read_symmetries(root, reading);
  read_bars(root, reading);
  read_loads(root, reading);
  read_initial_velocities(root, reading);
  read_initial_displacements(root, reading);
  read_contacts(root, reading);
  read_gravity(root, reading);
  read_damping(root, reading);
  read_effects(root, reading);
  read_output(root, reading);  // before what it is a default of
  read_probes(root, reading);
  read_sections(root, reading);
  read_time(root, reading);
  read_settling(root, reading);  // last: it asks whether anything moves
  root.done();
  faults.raise(file);
  for (std::string& text : singular_warnings(scene)) scene.warnings.push_back(std::move(text));
  return scene;
}

Scene read_scene(const std::string& file) {
  return parse_scene(read_text_file(file, "a scene file (TOML)"), file);
}

}  // namespace femsph
