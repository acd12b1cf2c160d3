#include "model/results/fields.hpp"

#include <numeric>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "model/results/hdf5.hpp"
#include "model/results/whole_file.hpp"
#include "model/results/xdmf.hpp"

namespace femsph {

namespace {

const std::string geometry_file = "fields/bodies.h5";

/// Only names that FieldWriter gives; the description first, so that it never refers to what is gone.
void remove_earlier_fields(const std::string& folder) {
  remove_file(folder + "/fields.xdmf");
  remove_file(folder + "/last_good.xdmf");
  for (const auto& entry : std::filesystem::directory_iterator(folder + "/fields")) {
    const std::string stem = entry.path().stem();
    const bool number = stem.size() >= 6 && stem.find_first_not_of("0123456789") == std::string::npos;
    if (entry.path().extension() == ".h5" && (number || stem == "bodies" || stem == "last_good")) remove_file(entry.path());
  }
}

/// A flat vector field as rows of three components.
std::vector<double> rows(const Layout& layout, const double* flat) {
  std::vector<double> out(3 * layout.points, 0.0);
  for (std::size_t i = 0; i < layout.points; ++i)
    for (int c = 0; c < layout.dim; ++c) out[3 * i + c] = flat[layout.at(i, c)];
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
    for (std::size_t k = 0; k < body.cell_points(); ++k) out.push_back(body.kind == Topology::Kind::points ? e : topology.cells[e][k]);
  return out;
}

/// Where the nine components xx xy xz yx yy yz zx zy zz stand in xx yy zz xy yz zx.
constexpr std::array<int, 9> full{0, 3, 5, 3, 1, 4, 5, 4, 2};

struct CellFields {
  std::vector<double> stress, strain, equivalent, plastic;  ///< plastic: empty when the law has none
};

/// Material points e k .. e k + k - 1 are those of cell e; k = 1 leaves every value as it is, to the last bit.
CellFields cell_means(const Discretization& d, const MaterialState& state, std::size_t cells) {
  CellFields out{std::vector<double>(9 * cells), std::vector<double>(9 * cells), std::vector<double>(cells),
                 std::vector<double>(state.plastic.empty() ? 0 : cells)};
  const std::size_t k = cells ? d.material_points() / cells : 0;
  for (std::size_t e = 0; e < cells; ++e) {
    double volume = 0;
    for (std::size_t q = e * k; q < (e + 1) * k; ++q) volume += d.material_volume(q);
    for (std::size_t q = e * k; q < (e + 1) * k; ++q) {
      const double share = d.material_volume(q) / volume;
      for (int c = 0; c < 9; ++c) {
        out.stress[9 * e + c] += share * state.stress[q][full[c]];
        out.strain[9 * e + c] += share * state.strain[q][full[c]];
      }
      out.equivalent[e] += share * von_mises(state.stress[q]);
      if (!state.plastic.empty()) out.plastic[e] += share * state.plastic[q];
    }
  }
  return out;
}

}  // namespace

struct FieldWriter::Impl {
  std::string folder;
  std::vector<const Discretization*> discretizations;
  std::vector<xdmf::Body> bodies;
  std::vector<xdmf::Frame> frames;  ///< on disk
  std::optional<hdf5::Image> geometry, data;
  xdmf::Frame frame;  ///< described by `data`
  MaterialState state;
  std::vector<std::size_t> all_points;

  void write_geometry();
  static std::string file_of(std::size_t frame) { return fmt::format("fields/{:06}.h5", frame); }
  void begin(long step, double time) {
    if (!data) {
      frame = {file_of(frames.size()), step, time, {}};
      data.emplace(folder + "/" + frame.file);
      data->attribute("/", "step", double(step));
      data->attribute("/", "time", time);
    }
    if (frame.step != step || frame.time != time)
      throw std::logic_error(fmt::format("fields of steps {} and {} in one snapshot: commit() is missing", frame.step, step));
  }
};

FieldWriter::FieldWriter(const std::string& folder, bool taken_up) : impl_(std::make_unique<Impl>()) {
  impl_->folder = folder;
  make_folder(folder);
  make_folder(folder + "/fields");
  if (!taken_up) remove_earlier_fields(folder);
  impl_->geometry.emplace(folder + "/" + geometry_file);
}

FieldWriter::~FieldWriter() = default;

std::size_t FieldWriter::add_body(const std::string& name, const Discretization& body) {
  if (!impl_->geometry) throw std::logic_error("fields: body \"" + name + "\" added after the first commit");
  const std::size_t number = impl_->bodies.size();
  const Topology topology = body.topology();
  const std::size_t points = body.layout().points;
  const bool bare = topology.kind == Topology::Kind::points;
  const xdmf::Body shape{name, topology.kind, points, bare ? points : topology.cells.size()};
  if (shape.cells > 0 && (body.material_points() % shape.cells != 0 || (bare && body.material_points() != points)))
    throw std::logic_error(
        fmt::format("fields: body \"{}\" has {} material points in {} cells", name, body.material_points(), shape.cells));

  hdf5::Image& image = *impl_->geometry;
  const std::string group = xdmf::group(number);
  image.dataset(group + "/points", reference_points(body), {points, 3});
  image.dataset(group + "/cells", connectivity(topology, shape), {shape.cells, shape.cell_points()});
  image.attribute(group, "name", name);
  impl_->bodies.push_back(shape);
  impl_->discretizations.push_back(&body);
  return number;
}

void FieldWriter::snapshot(std::size_t body, long step, double time, const double* u, const double* v) {
  impl_->begin(step, time);
  const Discretization& d = *impl_->discretizations.at(body);
  const std::size_t points = impl_->bodies[body].points, cells = impl_->bodies[body].cells;
  impl_->all_points.resize(d.material_points());
  std::iota(impl_->all_points.begin(), impl_->all_points.end(), std::size_t{0});
  impl_->state.plastic.clear();
  d.material_state(u, impl_->all_points, impl_->state);
  const CellFields means = cell_means(d, impl_->state, cells);

  hdf5::Image& image = *impl_->data;
  const std::string group = xdmf::group(body);
  image.dataset(group + "/displacement", rows(d.layout(), u), {points, 3});
  image.dataset(group + "/velocity", rows(d.layout(), v), {points, 3});
  image.dataset(group + "/stress", means.stress, {cells, 9});
  image.dataset(group + "/strain", means.strain, {cells, 9});
  image.dataset(group + "/equivalent_stress", means.equivalent, {cells, 1});
  impl_->bodies[body].plastic = !means.plastic.empty();
  if (impl_->bodies[body].plastic) image.dataset(group + "/plastic_strain", means.plastic, {cells, 1});
  impl_->frame.bodies.push_back(body);
}

void FieldWriter::Impl::write_geometry() {
  if (geometry) write_whole(geometry->bytes(), folder + "/" + geometry_file);
  geometry.reset();
}

void FieldWriter::commit() {
  Impl& w = *impl_;
  if (!w.data) return;
  w.write_geometry();
  write_whole(w.data->bytes(), w.folder + "/" + w.frame.file);
  w.data.reset();
  w.frames.push_back(w.frame);
  write_whole(xdmf::document(w.bodies, w.frames, geometry_file), w.folder + "/fields.xdmf");
}

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
