// Threads: every item once, sums the same to the last bit for any number of threads, errors carried back, thousands of short loops.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "model/numerics/parallel.hpp"

namespace femsph {
namespace {

struct Threads {
  explicit Threads(int n) { set_threads(n); }
  ~Threads() { set_threads(1); }
};

TEST(Parallel, EveryItemOnceWhateverTheThreads) {
  for (int t : {1, 2, 3, 5}) {
    const Threads use(t);
    for (int round = 0; round < 500; ++round) {
      std::vector<int> count(20011, 0);
      parallel_for(count.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++count[i];
      });
      for (int c : count) ASSERT_EQ(c, 1);
    }
  }
}

TEST(Parallel, SumsDoNotDependOnTheThreads) {
  std::vector<double> x(100003);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(double(i)) * std::exp(double(i % 40) - 20);
  const auto sum = [&](int t) {
    const Threads use(t);
    return parallel_sum(x.size(), [&](std::size_t begin, std::size_t end) {
      double s = 0;
      for (std::size_t i = begin; i < end; ++i) s += x[i];
      return s;
    });
  };
  EXPECT_EQ(sum(1), sum(2));
  EXPECT_EQ(sum(1), sum(7));
}

TEST(Parallel, AnErrorOfAnyThreadComesBack) {
  const Threads use(3);
  for (std::size_t bad : {0u, 9999u, 19999u})
    EXPECT_THROW(parallel_for(20000, 1,
                              [&](std::size_t begin, std::size_t end) {
                                if (begin <= bad && bad < end) throw std::runtime_error("bad");
                              }),
                 std::runtime_error);
  parallel_for(20000, 1, [](std::size_t, std::size_t) {});  // and the threads are still there
}

}  // namespace
}  // namespace femsph
