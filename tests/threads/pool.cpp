// The thread pool: every item once, sums the same to the last bit for any number of threads, errors passed
// on, thousands of short loops.

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

TEST(Parallel, ManySmallCallsWithChangingNumbersOfThreads) {
  std::vector<long> sum(8, 0);
  long expected = 0;
  for (int round = 0; round < 3000; ++round) {
    const int n = 1 + round / 300 % 5;
    run_on_threads(n, [&](int i) { sum[std::size_t(i)] += i + 1; });
    expected += n * (n + 1) / 2;
  }
  long all = 0;
  for (const long s : sum) all += s;
  EXPECT_EQ(all, expected);
}

// A loop inside a task runs on the task's own thread, every item once; a sum there is what it is outside.
TEST(Parallel, LoopsInsideATask) {
  std::vector<double> x(20011);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = 1 / double(i + 1);
  const auto sum = [&] {
    return parallel_sum(x.size(), [&](std::size_t begin, std::size_t end) {
      double s = 0;
      for (std::size_t i = begin; i < end; ++i) s += x[i];
      return s;
    });
  };
  const Threads use(3);
  const double outside = sum();
  for (int round = 0; round < 20; ++round) {
    std::vector<std::vector<int>> count(3, std::vector<int>(20011, 0));
    std::vector<double> inside(3);
    run_on_threads(3, [&](int i) {
      parallel_for(count[std::size_t(i)].size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) ++count[std::size_t(i)][k];
      });
      inside[std::size_t(i)] = sum();
    });
    for (int i = 0; i < 3; ++i) {
      for (const int c : count[std::size_t(i)]) ASSERT_EQ(c, 1);
      EXPECT_EQ(inside[std::size_t(i)], outside);
    }
  }
}

TEST(Parallel, ErrorsOfManyTasksAreOneError) {
  for (int round = 0; round < 200; ++round) {
    int caught = 0;
    try {
      run_on_threads(4, [&](int i) {
        if (i % 2 == round % 2) throw std::runtime_error("bad");
      });
    } catch (const std::runtime_error&) {
      ++caught;
    }
    ASSERT_EQ(caught, 1);
    long done = 0;
    run_on_threads(2, [&](int i) {
      if (i == 0) done = 1;  // and nothing is left over of it
    });
    ASSERT_EQ(done, 1);
  }
}

}  // namespace
}  // namespace femsph
