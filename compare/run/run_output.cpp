#include "compare/run/run_output.hpp"

#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <fstream>

namespace femsph::compare {

namespace {

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

/// Removes the files of an earlier run, so that the folder never holds results of two runs. Files whose names
/// other programs may also use are removed only if a record of this program is there. The scene that is being
/// run is never removed.
void remove_earlier_run(const std::string& folder, const std::string& scene) {
  namespace fs = std::filesystem;
  remove_earlier_fields(folder);
  if (fs::is_regular_file(checkpoint_file(folder))) fs::remove(checkpoint_file(folder));
  if (!has_record(folder)) return;
  std::vector<fs::path> ours;
  for (const char* name : {"/history.csv", "/history.h5", "/scene.toml", "/record.toml"})
    ours.emplace_back(folder + name);
  for (const auto& entry : fs::directory_iterator(folder))
    if (const std::string name = entry.path().filename();
        name.starts_with("section_") && name.ends_with(".csv"))
      ours.push_back(entry.path());
  std::error_code none;
  for (const fs::path& file : ours)
    if (fs::is_regular_file(file, none) && !fs::equivalent(file, scene, none)) fs::remove(file);
}

}  // namespace

std::string checkpoint_file(const std::string& folder) { return folder + "/checkpoint.h5"; }

bool has_record(const std::string& folder) {
  const std::string file = folder + "/record.toml", first = "# One run of femsph";
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return false;
  std::string line;
  std::ifstream in(file);
  return std::getline(in, line) && line.starts_with(first);
}

std::uint64_t checksum_of_meshes(const Scene& scene) {
  std::uint64_t sum = 0;
  const auto add = [&](const auto& values) {
    sum = checksum({reinterpret_cast<const char*>(values.data()), values.size() * sizeof values[0]}, sum);
  };
  for (const Body& body : scene.bodies)
    if (const CellMesh* mesh = body.shape->cells()) add(mesh->vertices), add(mesh->cells), add(mesh->facets);
  return sum;
}

RunOutput::RunOutput(const BodyMethods& methods, const RunOptions& options, March& march, Recorder& recorder,
                     double start_cpu)
    : methods_(methods),
      options_(options),
      march_(march),
      recorder_(recorder),
      folder_(*options.folder),
      start_cpu_(start_cpu),
      saved_at_(wall_seconds()) {
  const Scene& scene = march.scene();
  record_.scene_file = scene.file;
  record_.scene_text = scene.text;
  record_.method = methods.name;
  record_.command = options.command;
  const std::shared_ptr<const Checkpoint> from = options.checkpoint ? options.checkpoint->from : nullptr;
  if (!from) remove_earlier_run(folder_, scene.file);
  if (options.fields) {
    fields_ = std::make_unique<FieldWriter>(folder_, from != nullptr);
    for (const MovingBody& body : march.bodies())
      ids_.push_back(fields_->add_body(body.name, *body.discretization,
                                       scene.recovered_fields ? std::optional(scene.plane) : std::nullopt));
    march.keep_good_states();
  }
  if (!options.checkpoint) return;
  origin_ = {scene.file,
             from ? from->origin().scene_path : std::filesystem::absolute(scene.file).string(),
             scene.text,
             options.checkpoint->arguments,
             checksum_of_meshes(scene),
             {}};
  if (!from) return;
  if (from->origin().meshes != origin_.meshes)
    throw InputError(
        from->file(),
        {Fault{0, 0,
               "a mesh file of the scene has changed since the run began; expected the file of that time"}});
  from->restore([&](Archive& archive) { state(archive); });
  saved_progress_ = from->origin().progress;
}

void RunOutput::snapshot() {
  if (!fields_) return;
  for (std::size_t b = 0; b < ids_.size(); ++b) {
    const MovingBody& body = march_.bodies()[b];
    const Layout& at = body.discretization->layout();
    velocity_.assign(at.size, 0.0);
    for (std::size_t i = 0; i < at.points; ++i)
      for (int c = 0; c < at.dim; ++c) velocity_[at.at(i, c)] = march_.velocity(body, at.at(i, c));
    fields_->snapshot(ids_[b], march_.step(), march_.time(), body.u.data(), velocity_.data());
  }
  fields_->commit_later();
}

void RunOutput::state(Archive& archive) {
  archive.below("march", [&] { march_.state(archive); });
  archive.below("history", [&] { recorder_.state(archive); });
  if (fields_) archive.below("fields", [&] { fields_->state(archive); });
  archive.below("price", [&] { price_state(archive); });
}

/// The cost of the run until now. After a resume, the set-up counts each time that it was made.
void RunOutput::price_state(Archive& archive) {
  Price& price = march_.price();
  archive("cpu", price.cpu);
  archive("wall", price.wall);
  double total = cpu_before_ + cpu_seconds() - start_cpu_;
  archive("total_cpu", total);
  if (archive.restoring()) cpu_before_ = total;
  for (const char* phase : {"setup", "critical step", "step control", "contact", "watching", "sampling",
                            "fields", "checkpoints"}) {
    double seconds = 0;
    for (const auto& [name, spent] : price.phases)
      if (name == phase) seconds = spent;
    archive(phase, seconds);
    if (archive.restoring() && seconds > 0) price.add(phase, seconds);
  }
}

void RunOutput::save() {
  PhaseTimer timer(march_.price(), "checkpoints");
  origin_.progress = fmt::format(
      "step {} of {} (t = {:.6g} s)", march_.step(), march_.planned_steps(), march_.time());
  try {
    write_checkpoint(checkpoint_file(folder_), origin_, [&](Archive& archive) { state(archive); });
  } catch (const std::runtime_error& error) {
    if (saved_progress_.empty()) throw;
    throw std::runtime_error(fmt::format(
        "{}; the checkpoint of {} is complete: free some space, then `femsph resume {}` continues from there",
        error.what(), saved_progress_, folder_));
  }
  saved_at_ = wall_seconds();
  saved_progress_ = origin_.progress;
}

void RunOutput::between() {
  const CheckpointOptions& rule = *options_.checkpoint;
  const bool leave = interruption_.asked();
  if (!leave && !(rule.every_steps > 0 && march_.step() % rule.every_steps == 0) &&
      !(rule.every_seconds > 0 && wall_seconds() - saved_at_ >= rule.every_seconds))
    return;
  save();
  if (leave)
    throw Interrupted(
        fmt::format("interrupted at {}; `femsph resume {}` continues from there", saved_progress_, folder_));
}

void RunOutput::finish(const std::string& outcome, bool whole) {
  if (fields_) {
    PhaseTimer timer(march_.price(), "fields");
    fields_->settle();
  }
  write_csv(recorder_.history(), folder_ + "/history.csv");
  write_hdf5(recorder_.history(), folder_ + "/history.h5");
  if (whole) {
    for (const auto& [name, profile] : recorder_.profiles(march_))
      write_csv(profile, folder_ + "/section_" + name + ".csv");
    record_.ledger = march_.ledger();
  }
  record_.derived = derived_values(march_, methods_);
  record_.derived.emplace_back(
      "balance",
      fmt::format("{:.1e} of the forces, {:.1e} of their moments: loads + reactions - inertia, at worst",
                  recorder_.balance().force, recorder_.balance().moment));
  record_.warnings = warnings_of(march_, recorder_);
  record_.price = march_.price();
  record_.outcome = outcome;
  record_.finished_at = utc_now();
  write_record(record_, folder_);
  if (whole && options_.checkpoint) std::filesystem::remove(checkpoint_file(folder_));
}

void RunOutput::try_to_finish(const std::string& outcome) noexcept {
  try {
    finish(outcome, false);
  } catch (...) {
  }
}

std::string RunOutput::save_last_good() {
  if (!fields_ || !march_.return_to_good_state()) return {};
  for (std::size_t b = 0; b < ids_.size(); ++b)
    fields_->snapshot(
        ids_[b], march_.step(), march_.time(), march_.bodies()[b].u.data(), march_.bodies()[b].v.data());
  fields_->commit_alone("last_good", fmt::format("last good state, step {}", march_.step()));
  return fmt::format("; the last good state (step {}, t = {:.6g} s) is in {}/last_good.xdmf", march_.step(),
                     march_.time(), folder_);
}

}  // namespace femsph::compare
