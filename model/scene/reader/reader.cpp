#include "model/scene/reader/reader.hpp"

#include "model/motion/effects/catalogue.hpp"
#include "model/scene/reader/scene_page.hpp"
#include "model/scene/reader/scene_parts.hpp"
#include "model/scene/singular.hpp"

namespace femsph {
namespace scene_reader {
namespace {

const std::vector<std::pair<std::string, Plane>> planes = {
    {"stress", Plane::stress}, {"strain", Plane::strain}, {"none", Plane::none}};
const std::vector<std::pair<std::string, bool>> motions = {{"small", false}, {"large", true}};

}  // namespace

KeyTable top_keys() {
  return {
      "", "Keys before the first table.", {{"title", key_holds::text, "A title for reports and records."}}};
}

KeyTable model_keys() {
  return {"[model]",
          "What holds for the whole scene.",
          {{"plane", key_holds::words(planes), "Plane stress, plane strain, or \"none\": three-dimensional.",
            true},
           {"motion", key_holds::words(motions),
            "\"small\": small displacements and strains, as in linear analysis. \"large\": finite rotations "
            "and strains. \"small\" unless given."}},
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
  reading.motion_known = large || (!model->has("motion") && !model->misspelt({"motion"}));
}

KeyTable time_keys() {
  return {
      "[time]",
      "The simulated time, and how often results are kept.",
      {{"duration", key_holds::quantity(dimension::time), "The simulated time; with [settling] the longest.",
        true},
       {"samples", key_holds::count, "Number of rows of the histories over the duration. 400 unless given."},
       {"snapshots", key_holds::count,
        "Number of times that fields are written over the duration. 20 unless given."}},
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
  read_bodies(root, reading);  // before the tables that refer to a body
  read_output(root, reading);  // before probes and sections, whose defaults it sets
  read_probes(root, reading);
  read_sections(root, reading);
  read_time(root, reading);
  for (const EffectEntry& effect : effects())
    if (effect.read) effect.read(root, reading);
  root.done();
  faults.raise(file);
  for (std::string& text : singular_warnings(scene)) scene.warnings.push_back(std::move(text));
  return scene;
}

Scene read_scene(const std::string& file) {
  return parse_scene(read_text_file(file, "a scene file (TOML)"), file);
}

}  // namespace femsph
