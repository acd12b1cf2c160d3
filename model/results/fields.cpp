#include "model/results/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <future>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "model/numerics/parallel.hpp"
#include "model/numerics/principal.hpp"
#include "model/results/flow_limit.hpp"
#include "model/results/hdf5.hpp"
#include "model/results/recovery.hpp"
#include "model/results/whole_file.hpp"
#include "model/results/xdmf.hpp"

namespace femsph {

namespace {

const std::string geometry_file = "fields/bodies.h5";

/// A flat vector field as rows of three components.
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

/// Where the nine components xx xy xz yx yy yz zx zy zz stand in xx yy zz xy yz zx.
constexpr std::array<int, 9> full{0, 3, 5, 3, 1, 4, 5, 4, 2};

struct CellFields {
  std::vector<double> stress, strain, equivalent, principal,
      plastic;         ///< plastic: empty when the law has none
  MaterialState flow;  ///< of it the bounds of the stress, means too, when points are to be recovered
};

/// a b + c as the compiler contracts such a sum where the processor can: said outright, since how it unrolls
/// the loop around must not change the bits.
double multiply_add(double a, double b, double c) {
#ifdef __FMA__
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}

/// Part of its cell's volume that each material point stands for; empty when a cell has one. Nothing deformed
/// enters: once and for all.
std::vector<double> shares_of(const Discretization& d, std::size_t cells) {
  const std::size_t k = cells ? d.material_points() / cells : 0;
  std::vector<double> share(k > 1 ? d.material_points() : 0);
  if (!share.empty())
    parallel_for(
        cells, 64,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t e = begin; e < end; ++e) {
            double volume = 0;
            for (std::size_t q = e * k; q < (e + 1) * k; ++q) volume += share[q] = d.material_volume(q);
            for (std::size_t q = e * k; q < (e + 1) * k; ++q) share[q] /= volume;
          }
        },
        k);
  return share;
}

/// Means over cells, some thousands at a time, so that their points' states stay near the processor. What a
/// discretization prepares for one call (mirrored particles) it prepares for eight of them at most.
class Means {
 public:
  void fill(const Discretization& d, const double* u, const std::vector<double>& share, std::size_t cells,
            bool with_flow, CellFields& out) {
    const std::size_t k = cells ? d.material_points() / cells : 0;
    const std::size_t at_once = cells ? std::max(std::size_t{16384}, d.material_points() / 8) / k : 0;
    out.stress.resize(9 * cells);
    out.strain.resize(9 * cells);
    out.equivalent.resize(cells);
    out.principal.resize(3 * cells);
    state_.plastic.clear();
    for (std::size_t first = 0; first < cells; first += at_once) {
      const std::size_t count = std::min(at_once, cells - first);
      points_.resize(count * k);
      std::iota(points_.begin(), points_.end(), first * k);
      d.material_state(u, points_, state_);
      if (with_flow)
        for (const auto bound : bounds) (out.flow.*bound).resize((state_.*bound).empty() ? 0 : cells);
      out.plastic.resize(state_.plastic.empty() ? 0 : cells);
      parallel_for(
          count, 64,
          [&](std::size_t begin, std::size_t end) {
            for (std::size_t e = begin; e < end; ++e) {
              const double* shares = share.empty() ? nullptr : &share[(first + e) * k];
              mean(e, first + e, k, shares, out);
              for (const auto bound : bounds)
                if (with_flow && !(state_.*bound).empty())
                  (out.flow.*bound)[first + e] = mean_of(state_.*bound, e, k, shares);
            }
          },
          k);
    }
    if (cells == 0) out.plastic.clear();
  }

 private:
  static constexpr std::array bounds{
      &MaterialState::flow_stress, &MaterialState::tensile_flow_stress, &MaterialState::tensile_strength};
  static double mean_of(const std::vector<double>& values, std::size_t e, std::size_t k,
                        const double* shares) {
    double sum = 0;
    for (std::size_t n = 0; n < k; ++n) sum += (shares ? shares[n] : 1.0) * values[e * k + n];
    return sum;
  }
  /// Points e k .. e k + k - 1 of state_ are those of `cell`; k = 1 leaves every value as it is, to the last
  /// bit.
  void mean(std::size_t e, std::size_t cell, std::size_t k, const double* shares, CellFields& out) const {
    double stress[9] = {}, strain[9] = {}, equivalent = 0, plastic = 0;
    for (std::size_t n = 0; n < k; ++n) {
      const std::size_t q = e * k + n;
      const double share = shares ? shares[n] : 1.0;
      for (int c = 0; c < 9; ++c) {
        stress[c] = multiply_add(share, state_.stress[q][full[c]], stress[c]);
        strain[c] = multiply_add(share, state_.strain[q][full[c]], strain[c]);
      }
      equivalent += share * von_mises(state_.stress[q]);
      if (!state_.plastic.empty()) plastic += share * state_.plastic[q];
    }
    std::copy_n(stress, 9, &out.stress[9 * cell]);
    std::copy_n(strain, 9, &out.strain[9 * cell]);
    out.equivalent[cell] = equivalent;
    const std::array<double, 3> principal = principal_values(
        {stress[0], stress[4], stress[8], stress[1], stress[5], stress[2]});  // of the mean
    std::copy(principal.begin(), principal.end(), &out.principal[3 * cell]);
    if (!state_.plastic.empty()) out.plastic[cell] = plastic;
  }

  MaterialState state_;
  std::vector<std::size_t> points_;
};

/// Stress and strain at the points by the one rule, from the means of the units around: their weights, and
/// the values of the last snapshot.
class AtPoints {
 public:
  AtPoints(const Discretization& d, Plane plane) : plane_(plane) {
    const Recovery rule(d.material_units());
    const std::size_t points = d.layout().points;
    std::vector<std::vector<Weight>> all(points);
    parallel_for(
        points, 64,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) all[i] = rule.unit_weights(d.position(i));
        },
        64);
    begin_.assign(points + 1, 0);
    for (std::size_t i = 0; i < points; ++i) begin_[i + 1] = begin_[i] + all[i].size();
    near_.reserve(begin_.back());
    for (std::vector<Weight>& weights : all) {
      for (const Weight& w : weights) near_.push_back({std::uint32_t(w.point), float(w.weight)});
      std::vector<Weight>().swap(weights);
    }
  }

  void fill(const CellFields& cells) {
    const std::size_t points = begin_.size() - 1;
    values.stress.resize(9 * points);
    values.strain.resize(9 * points);
    values.equivalent.resize(points);
    values.principal.resize(3 * points);
    values.plastic.resize(cells.plastic.empty() ? 0 : points);
    parallel_for(
        points, 64,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) value(i, cells);
        },
        32);
  }
  CellFields values;

 private:
  void value(std::size_t i, const CellFields& cells) {
    std::array<double, 6> stress{}, strain{};
    for (std::size_t n = begin_[i]; n < begin_[i + 1]; ++n)
      for (std::size_t c = 0; c < 6; ++c) {
        stress[c] = multiply_add(near_[n].weight, cells.stress[9 * near_[n].unit + six[c]], stress[c]);
        strain[c] = multiply_add(near_[n].weight, cells.strain[9 * near_[n].unit + six[c]], strain[c]);
      }
    if (!cells.flow.flow_stress.empty()) {
      StressBound bound{};
      bound.yield = kept(i, cells.flow.flow_stress);
      bound.tensile = cells.flow.tensile_flow_stress.empty() ? bound.yield
                                                             : kept(i, cells.flow.tensile_flow_stress);
      bound.strength = cells.flow.tensile_strength.empty() ? std::numeric_limits<double>::infinity()
                                                           : kept(i, cells.flow.tensile_strength);
      stress = limited(stress, bound, plane_);
    }
    for (std::size_t c = 0; c < 9; ++c)
      values.stress[9 * i + c] = stress[std::size_t(full[c])],
                            values.strain[9 * i + c] = strain[std::size_t(full[c])];
    values.equivalent[i] = von_mises(stress);
    const std::array<double, 3> principal = principal_values(stress);
    std::copy(principal.begin(), principal.end(), &values.principal[3 * i]);
    if (!cells.plastic.empty()) values.plastic[i] = kept(i, cells.plastic);
  }
  /// Within the range of the units used.
  double kept(std::size_t i, const std::vector<double>& of_units) const {
    double sum = 0, low = of_units[near_[begin_[i]].unit], high = low;
    for (std::size_t n = begin_[i]; n < begin_[i + 1]; ++n) {
      const double v = of_units[near_[n].unit];
      if (std::isinf(v)) return v;
      sum = multiply_add(near_[n].weight, v, sum);
      low = std::min(low, v), high = std::max(high, v);
    }
    return std::clamp(sum, low, high);
  }

  static constexpr std::array<std::size_t, 6> six{0, 4, 8, 1, 5, 2};  ///< xx yy zz xy yz zx in nine
  struct Near {
    std::uint32_t unit;
    float weight;
  };
  Plane plane_;
  std::vector<std::size_t> begin_;  ///< of each point, in near_
  std::vector<Near> near_;
};

}  // namespace

struct FieldWriter::Impl {
  std::string folder;
  std::vector<const Discretization*> discretizations;
  std::vector<xdmf::Body> bodies;
  std::vector<xdmf::Frame> frames;  ///< on disk
  std::optional<hdf5::Image> geometry, data;
  xdmf::Frame frame;                                 ///< described by `data`
  std::vector<std::vector<double>> shares;           ///< of each body, from its first snapshot on
  std::vector<std::optional<Plane>> recovered;       ///< of each body: its points have recovered values too
  std::vector<std::unique_ptr<AtPoints>> at_points;  ///< of these, from the first snapshot on
  Means means;
  CellFields
      cells;  ///< these two for their memory: pages asked for anew cost as much as what is written on them
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

/// The description first, so that it never refers to what is gone.
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
  std::filesystem::remove(folder + "/fields", none);  // unless something of others is in there
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
  if (share.empty()) share = shares_of(d, cells);
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
    std::unique_ptr<AtPoints>& at = impl_->at_points[body];
    if (!at) at = std::make_unique<AtPoints>(d, *impl_->recovered[body]);
    at->fill(means);
    const CellFields& read = at->values;
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
