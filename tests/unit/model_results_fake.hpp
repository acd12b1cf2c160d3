#pragma once
// Small bodies whose numbers are known: a mesh of two quadrilaterals, and five particles in padded
// rows.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "model/motion/bodies/discretization.hpp"

namespace femsph::test {

/// A discretization that has only what output needs. Stress of material point m: {1, 2, 3, 4, 5, 6} + 10
/// m; strain: that / 1000.
class FakeBody : public Discretization {
 public:
  std::string describe() const override { return "fake"; }
  const Layout& layout() const override { return layout_; }
  std::span<const double> mass() const override { return {}; }
  Point position(std::size_t i) const override { return points_[i]; }
  std::size_t units() const override { return 0; }
  std::string unit_name() const override { return "fake"; }
  double spacing() const override { return 1; }
  double wave_speed() const override { return 1; }
  std::size_t bytes() const override { return 0; }
  void internal_force(const double*, const double*, double, double*, double*) override {}
  void stiffness(const double*, double*) const override {}
  void damping_matrix(const double*, double*) const override {}
  Energies energies(const double*) const override { return {}; }
  std::vector<Weight> points_of(const Place&) const override { return {}; }
  std::vector<Weight> interpolation(const Point&) const override { return {}; }
  std::size_t material_points() const override { return volumes_.size(); }
  Point material_position(std::size_t) const override { return {}; }
  double material_volume(std::size_t m) const override { return volumes_[m]; }
  std::vector<Weight> material_interpolation(const Point&) const override { return {}; }
  void material_state(const double*, std::span<const std::size_t> points, MaterialState& out) const override {
    out.stress.resize(points.size());
    out.strain.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      for (std::size_t c = 0; c < 6; ++c) {
        out.stress[k][c] = 1.0 + double(c) + 10.0 * double(points[k]);
        out.strain[k][c] = out.stress[k][c] / 1000;
      }
  }
  Topology topology() const override { return topology_; }

  /// A flat field whose component c of point i is i + c / 10 + offset; padding is -1, which must never come
  /// out.
  std::vector<double> field(double offset) const {
    std::vector<double> flat(layout_.size, -1.0);
    for (std::size_t i = 0; i < layout_.points; ++i)
      for (int c = 0; c < layout_.dim; ++c) flat[layout_.at(i, c)] = double(i) + c / 10.0 + offset;
    return flat;
  }

 protected:
  Layout layout_;
  std::vector<Point> points_;
  std::vector<double> volumes_;
  Topology topology_;
};

/// 3 -- 4 -- 5
/// 0 -- 1 -- 2, interleaved components; each cell has two quadrature points of volumes 1 and 3.
struct FakeMesh : FakeBody {
  FakeMesh() {
    layout_ = {6, 2, 2, 1, 0, 12};
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) points_.push_back({double(i), double(j), 0});
    volumes_ = {1, 3, 1, 3};
    topology_ = {Topology::Kind::quadrilaterals, {{0, 1, 4, 3}, {1, 2, 5, 4}}};
  }
};

/// Two unit cubes side by side along x.
struct FakeBlock : FakeBody {
  FakeBlock() {
    layout_ = {12, 3, 3, 1, 0, 36};
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 3; ++i) points_.push_back({double(i), double(j), double(k) + 2});
    volumes_ = {1, 1};
    topology_ = {Topology::Kind::hexahedra, {{0, 1, 4, 3, 6, 7, 10, 9}, {1, 2, 5, 4, 7, 8, 11, 10}}};
  }
};

/// Five particles on a line; one row per component, padded to eight, after four slots of padding. Volume 0.7
/// each.
struct FakeParticles : FakeBody {
  FakeParticles() {
    layout_ = {5, 2, 1, 8, 4, 20};
    for (int i = 0; i < 5; ++i) points_.push_back({0.5 * i, 3.0, 0});
    volumes_.assign(5, 0.7);
  }
};

/// A temporary folder, removed after the test.
class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "femsph_results_XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }
  /// Every file below, relative.
  std::set<std::string> files() const {
    std::set<std::string> out;
    for (const auto& e : std::filesystem::recursive_directory_iterator(path_))
      if (!e.is_directory()) out.insert(e.path().lexically_relative(path_).string());
    return out;
  }

 private:
  std::string path_;
};

inline std::string read(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

}  // namespace femsph::test
