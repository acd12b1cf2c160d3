#include "model/scene/reader/reader.hpp"

#include "model/scene/reader/scene_page.hpp"
#include "model/scene/reader/scene_reader.hpp"
#include "model/scene/singular.hpp"

namespace femsph {
namespace scene_reader {
namespace {

const std::vector<std::pair<std::string, Plane>> planes = {
    {"stress", Plane::stress}, {"strain", Plane::strain}, {"none", Plane::none}};
const std::vector<std::pair<std::string, bool>> motions = {{"small", false}, {"large", true}};

}  // namespace

KeyTable top_keys() {
  return {"", "Keys before the first table.", {{"title", key_holds::text, "One line for people."}}};
}

KeyTable model_keys() {
  return {
      "[model]",
      "What all bodies have in common.",
      {{"plane", key_holds::words(planes), "Plane stress, plane strain, or none: three-dimensional.", true},
       {"motion", key_holds::words(motions),
        "\"large\" lets material axes rotate and strains be finite. \"small\" unless given."}},
      {},
      {},
      true};
}

void read_model(Fields& root, Reading& reading) {
  auto model = root.table("model", Need::required, "a table with plane = \"stress\", \"strain\" or \"none\"");
  if (!model) return;
  const auto plane = model->choice("plane", Need::required, planes);
  const auto large = model->choice("motion", Need::optional, motions);
  model->done();
  reading.scene.plane = plane.value_or(Plane::stress);
  reading.scene.large_motion = large.value_or(false);
  if (plane) reading.dim = reading.scene.dim();
  reading.motion_known = large || !model->has("motion");
}

KeyTable time_keys() {
  return {"[time]",
          "How long the scene is followed, and what is kept of it.",
          {{"duration", key_holds::quantity(dimension::time), "With [settling]: at most this long.", true},
           {"samples", key_holds::count, "Rows of the histories over the duration. 400 unless given."},
           {"snapshots", key_holds::count, "Fields written over the duration. 20 unless given."}},
          {},
          {},
          true};
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
  Fields root(table, faults, scene_page());
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
