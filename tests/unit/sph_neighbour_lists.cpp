// Cell lists and lists of moving neighbours against a search of all pairs.

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "sph/operators/moving_neighbours.hpp"
#include "sph/particles/cell_list.hpp"
#include "sph_support.hpp"

namespace femsph::test {
namespace {

/// Scattered points: most in a box, some far, some very far, some not finite.
std::vector<Point> scattered(std::size_t count, int dim, double far) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = i % 10 == 0 ? far : 1;
    Point p{};
    for (int a = 0; a < dim; ++a) p[std::size_t(a)] = size * unit(random);
    points.push_back(p);
    if (i % 10 == 0) {  // and one near it
      for (int a = 0; a < dim; ++a) p[std::size_t(a)] += 0.03 * unit(random);
      points.push_back(p);
    }
  }
  return points;
}

TEST(CellList, FindsEveryPairOnceHoweverFarTheyAreScattered) {
  for (int dim : {2, 3})
    for (double far : {1.0, 30.0, 1e6, 1e12}) {
      std::vector<Point> points = scattered(800, dim, far);
      points.push_back({nan, 0.5, 0});
      points.push_back({0.5, infinite, 0});
      points.push_back({-infinite, nan, 0});
      points.push_back({1e300, -1e300, 0});
      const double radius = 0.1;
      const sph::CellList cells(points, dim, radius);
      EXPECT_LT(cells.bytes(), 40000u + 60 * points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        std::vector<int> found(points.size(), 0);
        cells.around(points[i], [&](int j) { ++found[std::size_t(j)]; });
        for (std::size_t j = 0; j < points.size(); ++j) {
          double r2 = 0;
          for (std::size_t a = 0; a < 3; ++a)
            r2 += (points[j][a] - points[i][a]) * (points[j][a] - points[i][a]);
          ASSERT_LE(found[j], 1);
          if (r2 < radius * radius) {
            ASSERT_EQ(found[j], 1) << dim << " " << far << " " << i << " " << j;
          }
        }
      }
    }
}

struct Crowd {
  std::vector<Point> start;
  Layout layout;
  AlignedVector<double> u;
  explicit Crowd(int n) {
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) start.push_back({double(i), double(j), 0});
    layout = {start.size(), 2, 1, round_up(start.size(), lanes), 0, 2 * round_up(start.size(), lanes)};
    u.assign(layout.size, 0.0);
  }
};

TEST(MovingNeighbours, ListsHoldEveryPairWithinReachUntilTheySearchAgain) {
  Crowd c(10);
  const double radius = 2.4;
  sph::MovingNeighbours lists(c.start, c.layout, radius, 0.3);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> move(-0.01, 0.012);
  const int steps = 150;
  for (int step = 0; step < steps; ++step) {
    lists.update(c.u.data());
    std::vector<std::vector<std::int32_t>> listed(c.start.size());
    lists.each_block([&](std::size_t block, const std::int32_t* index, const std::int32_t* end) {
      for (; index != end; index += lanes)
        for (std::size_t l = 0; l < lanes; ++l)
          if (block * lanes + l < c.start.size() && index[l] != std::int32_t(block * lanes + l))
            listed[block * lanes + l].push_back(index[l]);
    });
    for (std::size_t i = 0; i < c.start.size(); ++i)
      for (std::size_t j = 0; j < c.start.size(); ++j) {
        const double x = c.start[j][0] + c.u[c.layout.at(j, 0)] - c.start[i][0] - c.u[c.layout.at(i, 0)];
        const double y = c.start[j][1] + c.u[c.layout.at(j, 1)] - c.start[i][1] - c.u[c.layout.at(i, 1)];
        const auto times = std::count(listed[i].begin(), listed[i].end(), std::int32_t(j));
        ASSERT_LE(times, 1);
        if (i != j && x * x + y * y < radius * radius) {
          ASSERT_EQ(times, 1) << step;
        }
      }
    for (std::size_t i = 0; i < c.start.size(); ++i)
      for (int a = 0; a < 2; ++a) c.u[c.layout.at(i, a)] += move(random) * (i % 7 == 0 ? 5 : 1);
  }
  EXPECT_GT(lists.searches(), 3);
  EXPECT_LT(lists.searches(), steps / 2);
}

TEST(MovingNeighbours, ABodyThatMovesAsAWholeKeepsItsLists) {
  Crowd c(10);
  sph::MovingNeighbours lists(c.start, c.layout, 2.4, 0.3);
  for (int step = 0; step < 50; ++step) {
    for (std::size_t i = 0; i < c.start.size(); ++i)
      c.u[c.layout.at(i, 0)] = 3.0 * step, c.u[c.layout.at(i, 1)] = 0.05 * std::sin(step + double(i));
    lists.update(c.u.data());
  }
  EXPECT_EQ(lists.searches(), 1);
}

TEST(MovingNeighbours, NoticesAParticleThatTheOthersHaveLeftAndAHeap) {
  Crowd c(10);
  sph::MovingNeighbours lists(c.start, c.layout, 2.4, 0.3);
  lists.update(c.u.data());
  EXPECT_FALSE(lists.loss());
  c.u[c.layout.at(99, 0)] =
      1;  // the corner moves out to (10, 10): of its seven within 2.4 it keeps (8, 9) and (9, 8), at 2.24
  c.u[c.layout.at(99, 1)] = 1;
  lists.update(c.u.data());
  ASSERT_TRUE(lists.loss());
  EXPECT_EQ(lists.loss()->particle, 99u);
  EXPECT_EQ(lists.loss()->neighbours, 2);
  EXPECT_EQ(lists.loss()->at_start, 7);
  EXPECT_EQ(lists.loss()->alone, 1u);
  for (std::size_t i = 0; i < c.start.size(); ++i)
    for (int a = 0; a < 2; ++a) c.u[c.layout.at(i, a)] = -c.start[i][std::size_t(a)];
  lists.update(c.u.data());
  EXPECT_TRUE(lists.crowded());
}

}  // namespace
}  // namespace femsph::test
