#include "model/results/fields.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <future>
#include <optional>
#include <stdexcept>

#include "model/numerics/parallel.hpp"
#include "model/results/hdf5.hpp"
#include "model/results/recovered_fields.hpp"
#include "model/results/whole_file.hpp"
#include "model/results/xdmf.hpp"

namespace femsph {

namespace {

const std::string geometry_file = "fields/bodies.h5";

/// A flat vector as rows of three components.
const std::vector<double>& rows(const Layout& layout, const double* flat, std::vector<double>& out) {
  out.resize(3 * layout.points);
  parallel_for(layout.points, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (int c = 0; c < 3; ++c) out[3 * i + std::size_t(c)] = c < layout.dim ? flat[layout.at(i, c)] : 0.0;
  });
  return out;
}

std::vector<double> reference_points(const Discretization& d) {
  std::vector<double> out;
  out.reserve(3 * d.layout().points);
  for (std::size_t i = 0; i < d.layout().points; ++i)
    for (double x : d.position(i)) out.push_back(x);
  return out;
}

std::vector<long long> connectivity(const Topology& topology, const xdmf::Body& body) {
  std::vector<long long> out;
  out.reserve(body.cells * body.cell_points());
  for (std::size_t e = 0; e < body.cells; ++e)
    for (std::size_t k = 0; k < body.cell_points(); ++k)
      out.push_back(body.kind == Topology::Kind::points ? e : topology.cells[e][k]);
  return out;
}

}  // namespace

struct FieldWriter::Impl {
  std::string folder;
  std::vector<const Discretization*> discretizations;
  std::vector<xdmf::Body> bodies;
  std::vector<xdmf::Frame> frames;  ///< on disk
  std::optional<hdf5::Image> geometry, data;
  xdmf::Frame frame;                            ///< described by `data`
  std::vector<std::vector<double>> shares;      ///< of each body, from its first snapshot on
  std::vector<std::optional<Plane>> recovered;  ///< of each body: its points have recovered values too
  std::vector<std::unique_ptr<RecoveredFields>> at_points;  ///< of these, from the first snapshot on
  CellMeans means;
  /// Buffers that are reused: allocating new memory costs as much as filling it.
  CellFields cells;
  std::vector<double> point_rows;
  std::future<void> writing;  ///< of `frame`, by commit_later()

  void write_geometry();
  void settle() {
    if (!writing.valid()) return;
    writing.get();
    frames.push_back(frame);
  }
  static std::string file_of(std::size_t frame) { return fmt::format("fields/{:06}.h5", frame); }
  void begin(long step, double time) {
    settle();
    if (!data) {
      frame = {file_of(frames.size()), step, time, {}};
      data.emplace(folder + "/" + frame.file);
      data->attribute("/", "step", double(step));
      data->attribute("/", "time", time);
    }
    if (frame.step != step || frame.time != time)
      throw std::logic_error(
          fmt::format("fields of steps {} and {} in one snapshot: commit() is missing", frame.step, step));
  }
};

/// The XDMF file is removed first, so that it never refers to files that are gone.
void remove_earlier_fields(const std::string& folder) {
  remove_file(folder + "/fields.xdmf");
  remove_file(folder + "/last_good.xdmf");
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder + "/fields", none)) {
    const std::string stem = entry.path().stem();
    const bool number = stem.size() >= 6 && stem.find_first_not_of("0123456789") == std::string::npos;
    if (entry.path().extension() == ".h5" && (number || stem == "bodies" || stem == "last_good"))
      remove_file(entry.path());
  }
  std::filesystem::remove(folder + "/fields", none);  // only if it is empty
}

FieldWriter::FieldWriter(const std::string& folder, bool taken_up) : impl_(std::make_unique<Impl>()) {
  impl_->folder = folder;
  make_folder(folder);
  if (!taken_up) remove_earlier_fields(folder);
  make_folder(folder + "/fields");
  impl_->geometry.emplace(folder + "/" + geometry_file);
}

FieldWriter::~FieldWriter() = default;

std::size_t FieldWriter::add_body(const std::string& name, const Discretization& body,
                                  std::optional<Plane> recovered) {
  if (!impl_->geometry) throw std::logic_error("fields: body \"" + name + "\" added after the first commit");
  const std::size_t number = impl_->bodies.size();
  const Topology topology = body.topology();
  const std::size_t points = body.layout().points;
  const bool bare = topology.kind == Topology::Kind::points;
  const xdmf::Body shape{name, topology.kind, points, bare ? points : topology.cells.size()};
  if (shape.cells > 0 &&
      (body.material_points() % shape.cells != 0 || (bare && body.material_points() != points)))
    throw std::logic_error(fmt::format(
        "fields: body \"{}\" has {} material points in {} cells", name, body.material_points(), shape.cells));

  hdf5::Image& image = *impl_->geometry;
  const std::string group = xdmf::group(number);
  image.dataset(group + "/points", reference_points(body), {points, 3});
  image.dataset(group + "/cells", connectivity(topology, shape), {shape.cells, shape.cell_points()});
  image.attribute(group, "name", name);
  impl_->bodies.push_back(shape);
  impl_->bodies.back().both = recovered && !body.material_units().place.empty();
  impl_->recovered.push_back(recovered);
  impl_->discretizations.push_back(&body);
  return number;
}

void FieldWriter::snapshot(std::size_t body, long step, double time, const double* u, const double* v) {
  impl_->begin(step, time);
  const Discretization& d = *impl_->discretizations.at(body);
  const std::size_t points = impl_->bodies[body].points, cells = impl_->bodies[body].cells;
  impl_->shares.resize(impl_->bodies.size());
  std::vector<double>& share = impl_->shares[body];
  if (share.empty()) share = volume_shares(d, cells);
  CellFields& means = impl_->cells;
  impl_->means.fill(d, u, share, cells, impl_->bodies[body].both, means);

  hdf5::Image& image = *impl_->data;
  const std::string group = xdmf::group(body);
  image.dataset(group + "/displacement", rows(d.layout(), u, impl_->point_rows), {points, 3});
  image.dataset(group + "/velocity", rows(d.layout(), v, impl_->point_rows), {points, 3});
  image.dataset(group + "/stress", means.stress, {cells, 9});
  image.dataset(group + "/strain", means.strain, {cells, 9});
  image.dataset(group + "/equivalent_stress", means.equivalent, {cells, 1});
  image.dataset(group + "/principal_stress", means.principal, {cells, 3});
  impl_->bodies[body].plastic = !means.plastic.empty();
  if (impl_->bodies[body].plastic) image.dataset(group + "/plastic_strain", means.plastic, {cells, 1});
  if (impl_->bodies[body].both) {
    impl_->at_points.resize(impl_->bodies.size());
    std::unique_ptr<RecoveredFields>& at = impl_->at_points[body];
    if (!at) at = std::make_unique<RecoveredFields>(d, *impl_->recovered[body]);
    at->fill(means);
    const CellFields& read = at->values();
    image.dataset(group + "/recovered_stress", read.stress, {points, 9});
    image.dataset(group + "/recovered_strain", read.strain, {points, 9});
    image.dataset(group + "/recovered_equivalent_stress", read.equivalent, {points, 1});
    image.dataset(group + "/recovered_principal_stress", read.principal, {points, 3});
    if (!read.plastic.empty()) image.dataset(group + "/recovered_plastic_strain", read.plastic, {points, 1});
  }
  impl_->frame.bodies.push_back(body);
}

void FieldWriter::Impl::write_geometry() {
  if (geometry) write_whole(geometry->bytes(), folder + "/" + geometry_file);
  geometry.reset();
}

void FieldWriter::commit() {
  commit_later();
  settle();
}

void FieldWriter::commit_later() {
  Impl& w = *impl_;
  if (!w.data) return;
  w.write_geometry();
  std::vector<xdmf::Frame> then = w.frames;
  then.push_back(w.frame);
  w.writing = std::async(std::launch::async, [image = w.data->bytes(), file = w.folder + "/" + w.frame.file,
                                              description = xdmf::document(w.bodies, then, geometry_file),
                                              all = w.folder + "/fields.xdmf"]() mutable {
    write_whole(image, file);
    std::string().swap(image);
    write_whole(description, all);
  });
  w.data.reset();
}

void FieldWriter::settle() { impl_->settle(); }

void FieldWriter::commit_alone(const std::string& name, const std::string& label) {
  Impl& w = *impl_;
  if (!w.data) return;
  w.write_geometry();
  w.frame.file = "fields/" + name + ".h5";
  w.data->attribute("/", "label", label);
  write_whole(w.data->bytes(), w.folder + "/" + w.frame.file);
  w.data.reset();
  write_whole(xdmf::document(w.bodies, {w.frame}, geometry_file, label), w.folder + "/" + name + ".xdmf");
}

void FieldWriter::state(Archive& archive) {
  Impl& w = *impl_;
  w.settle();
  std::size_t count = w.frames.size();
  archive("frames", count);
  w.frames.resize(count);
  for (std::size_t k = 0; k < count; ++k)
    archive.below(std::to_string(k), [&] {
      archive("step", w.frames[k].step);
      archive("time", w.frames[k].time);
      archive("bodies", w.frames[k].bodies);
      w.frames[k].file = w.file_of(k);
    });
  for (xdmf::Body& body : w.bodies) archive("plastic of " + body.name, body.plastic);
}

}  // namespace femsph
