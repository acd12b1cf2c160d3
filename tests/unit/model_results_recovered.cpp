// Recovered fields beside the raw ones: the value at every node is what a probe reads there, and plastic
// bodies stay on their yield surface.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/numerics/vectors.hpp"
#include "model/results/fields.hpp"
#include "model/results/flow_limit.hpp"
#include "model/results/recovery.hpp"
#include "tests/unit/model_grid.hpp"
#include "tests/unit/model_results_hdf5.hpp"

namespace femsph::test {
namespace {

/// One point a cell, with a stress that is linear over the body, ideally plastic at `yield` if that is given.
class StressedGrid : public Grid {
 public:
  explicit StressedGrid(double yield = 0) : Grid({0, 0, 0}, 2.0, 1.0, 8, 5), yield_(yield) {
    for (const auto& cell : topology_.cells) {
      centres_.push_back(0.25 * (points_[cell[0]] + points_[cell[1]] + points_[cell[2]] + points_[cell[3]]));
      volumes_.push_back(0.05);
    }
  }
  static std::array<double, 6> stress(const Point& x) { return {1 + x[0], 2 - x[1], 0, x[0] - x[1], 0, 0}; }
  Point material_position(std::size_t m) const override { return centres_[m]; }
  MaterialUnits material_units() const override {
    return {2, 1, centres_, volumes_, {{0.0625, 0.04, 0, 0, 0, 0}}, {}};
  }
  void material_state(const double*, std::span<const std::size_t> points, MaterialState& out) const override {
    out = {};
    for (const std::size_t p : points) {
      out.stress.push_back(stress(centres_[p]));
      out.strain.push_back({});
      if (yield_ > 0) out.flow_stress.push_back(yield_), out.plastic.push_back(centres_[p][0] - 0.125);
    }
  }

 private:
  double yield_;
  std::vector<Point> centres_;
};

std::string written(const Folder& folder, const StressedGrid& body, std::optional<Plane> recovered) {
  FieldWriter writer(folder.path());
  writer.add_body("plate", body, recovered);
  const std::vector<double> zero(body.layout().size, 0.0);
  writer.snapshot(0, 0, 0.0, zero.data(), zero.data());
  writer.commit();
  return folder / "fields/000000.h5";
}

TEST(RecoveredFields, AreWhatAProbeReads) {
  const StressedGrid body;
  const Folder folder;
  const std::string file = written(folder, body, Plane::stress);
  const auto stress = read_hdf5(file, "/body0/recovered_stress"),
             equivalent = read_hdf5(file, "/body0/recovered_equivalent_stress");
  EXPECT_THAT(stress.shape, testing::ElementsAre(54u, 9u));
  for (std::size_t i = 0; i < 54; ++i) {
    const auto exact = StressedGrid::stress(
        body.position(i));  // linear: exact but for weights of single precision
    EXPECT_NEAR(stress.values[9 * i], exact[0], 1e-6);
    EXPECT_NEAR(stress.values[9 * i + 1], exact[3], 1e-6);
    EXPECT_NEAR(stress.values[9 * i + 4], exact[1], 1e-6);
    EXPECT_NEAR(equivalent.values[i], von_mises(exact), 1e-6);
  }
  EXPECT_THAT(
      read(folder / "fields.xdmf"),
      testing::HasSubstr("<Attribute Name=\"recovered_stress\" AttributeType=\"Tensor\" Center=\"Node\">"));
  EXPECT_THAT(read(folder / "fields.xdmf"), testing::Not(testing::HasSubstr("recovered_plastic_strain")));
}

TEST(RecoveredFields, StayOnTheYieldSurface) {
  const StressedGrid body(2.0);
  const Folder folder;
  const std::string file = written(folder, body, Plane::stress);
  double most = 0;
  for (const double q : read_hdf5(file, "/body0/recovered_equivalent_stress").values)
    most = std::max(most, q);
  EXPECT_NEAR(most, 2, 1e-12);
  const auto plastic =
      read_hdf5(file, "/body0/recovered_plastic_strain").values;  // within what the cells have
  EXPECT_NEAR(*std::max_element(plastic.begin(), plastic.end()), 1.75, 1e-12);
  EXPECT_NEAR(*std::min_element(plastic.begin(), plastic.end()), 0, 1e-12);
}

TEST(RecoveredFields, AreNotThereUnlessAskedFor) {
  const Folder folder;
  written(folder, StressedGrid(), {});
  EXPECT_THAT(read(folder / "fields.xdmf"), testing::Not(testing::HasSubstr("recovered")));
}

}  // namespace
}  // namespace femsph::test
