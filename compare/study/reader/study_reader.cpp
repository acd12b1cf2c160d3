#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "compare/study/reader/study_page.hpp"
#include "compare/study/reader/study_reading.hpp"
#include "model/input/lookup.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph::compare {
namespace {

namespace fs = std::filesystem;

Study parse(const std::string& text, const std::string& file, bool may_collect);

/// Studies whose rows this one collects: folders beside its own. They must not collect others.
void read_collected(Fields& root, StudyReading& reading, bool may_collect) {
  const auto names = root.texts("studies", Need::optional, "a list of studies, such as [\"uniaxial\"]");
  if (!names) return;
  if (!may_collect)
    return root.fault("studies", "a collected study has \"studies\" itself; expected one with runs only");
  for (const std::string& name : *names) {
    const fs::path file = fs::path(reading.study.folder) / ".." / name / "study.toml";
    if (name == reading.study.name) {
      root.fault("studies", fmt::format("{} is this study itself; expected other studies", in_quotes(name)));
    } else if (std::error_code ignored; !fs::exists(file, ignored)) {
      root.fault(
          "studies", fmt::format("no study is called {}; expected the name of a folder beside this study's",
                                 in_quotes(name)));
    } else {
      const std::string path = file.lexically_normal().string();
      reading.study.collected.push_back(parse(read_text_file(path, "a study file (TOML)"), path, false));
    }
  }
}

Study parse(const std::string& text, const std::string& file, bool may_collect) {
  const toml::table table = parse_toml(text, file);
  Faults faults;
  Fields root(table, faults, study_page());
  Study study;
  study.file = file;
  study.folder = fs::path(file).has_parent_path() ? fs::path(file).parent_path().string() : ".";
  study.name = fs::weakly_canonical(study.folder).filename().string();
  StudyReading reading{study, faults, "scene.toml"};

  study.title = root.text("title", Need::required, "a title").value_or("");
  reading.default_scene =
      root.text("scene", Need::optional, "the file of a scene").value_or(reading.default_scene);
  read_collected(root, reading, may_collect);
  read_runs(root, reading);  // first: it reads the scenes, which the others refer to
  read_repeat(root, reading);
  read_limit(root, reading);
  read_quantities(root, reading);
  read_prices(root, reading);
  read_advice(root, reading);
  read_series(root, reading);
  read_paper(root, reading);
  read_claims(root, reading);
  read_bounds(root, reading);
  root.done();
  if (faults.empty() && study.runs.empty() && study.collected.empty())
    faults.add({}, "the study runs nothing; expected [[runs]], or \"studies\" to collect");
  faults.raise(file);
  return study;
}

}  // namespace

KeyTable study_top_keys() {
  return {"",
          "Keys before the first table.",
          {{"title", key_holds::text, "One line that `femsph list` shows.", true},
           {"scene", "a text: the file of a scene, beside the study",
            "For [[runs]] that name no scene. \"scene.toml\" unless given."},
           {"studies", key_holds::texts,
            "Names of studies beside this one that are run too; this study's claims can use their rows."},
           {"repeat", key_holds::count,
            "How often every run is made, to measure the spread of its time (not with --quick). 1 unless "
            "given."}}};
}

const Scene* scene_of(const Fields& fields, const char* key, const std::string& file, StudyReading& reading) {
  auto& scenes = reading.study.scenes;
  if (const auto known = scenes.find(file); known != scenes.end()) return &known->second;
  if (reading.bad_scenes.contains(file)) return nullptr;
  try {
    return &scenes.emplace(file, read_scene((fs::path(reading.study.folder) / file).string())).first->second;
  } catch (const InputError& e) {
    reading.bad_scenes.insert(file);
    fields.fault(key, fmt::format("the scene {} cannot be used:\n{}", in_quotes(file), e.what()));
    return nullptr;
  }
}

bool require_known(const Fields& fields, const char* key, const std::string& what, const std::string& name,
                   const std::vector<std::string>& known, bool complete) {
  if (complete) return fields.position_of(name, known, key, what).has_value();
  return std::find(known.begin(), known.end(), name) != known.end();
}

std::vector<std::string> read_names(Fields& fields, const char* key, const std::vector<std::string>& known,
                                    const std::string& what, bool complete) {
  const auto names = fields.texts(key, Need::optional, fmt::format("a list of {}s", what));
  for (const std::string& name : names.value_or(std::vector<std::string>{}))
    require_known(fields, key, what, name, known, complete);
  return names.value_or(std::vector<std::string>{});
}

std::optional<std::string> read_scene_name(Fields& fields, Need need, const StudyReading& reading) {
  const auto name = fields.text("scene", need, "the file of a scene that a run uses");
  const auto& scenes = reading.study.scenes;
  if (!name || scenes.contains(*name)) return name;
  std::vector<std::string> known;
  for (const auto& [file, scene] : scenes) known.push_back(file);
  if (!reading.bad_scenes.contains(*name) && (reading.runs_known || !known.empty()))
    fields.fault(
        "scene", fmt::format("no run uses the scene {}{}", in_quotes(*name), expected_names(*name, known)));
  return {};
}

namespace {

template <class List, class Name>
std::vector<std::string> distinct(const List& list, Name name) {
  std::vector<std::string> names;
  for (const auto& item : list)
    if (std::find(names.begin(), names.end(), name(item)) == names.end()) names.push_back(name(item));
  return names;
}

}  // namespace

bool is_file_name(const std::string& text, const std::string& also) {
  const auto allowed = [&](unsigned char c) {
    return (c < 0x80 && std::isalnum(c)) || c == '_' || c == '-' || also.find(char(c)) != std::string::npos;
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), allowed);
}

std::vector<std::string> case_names(const Study& study) {
  return distinct(study.runs, [](const PlannedRun& run) { return run.case_name; });
}

std::vector<std::string> method_labels(const Study& study) {
  return distinct(study.runs, [](const PlannedRun& run) { return run.label; });
}

std::vector<std::string> quantity_names(const Study& study) {
  return distinct(study.quantities, [](const QuantitySpec& quantity) { return quantity.name; });
}

Study parse_study(const std::string& text, const std::string& file) { return parse(text, file, true); }

Study read_study(const std::string& file) {
  return parse_study(read_text_file(file, "a study file (TOML)"), file);
}

}  // namespace femsph::compare
