#include "model/numerics/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace femsph {

namespace {

int& thread_count() {
  static int n = 1;
  return n;
}

/// Whether this thread runs a task; loops inside of it then run on this thread only.
thread_local bool inside_task = false;

/// Waits until `value` differs from `old`: actively for 10 to 20 microseconds (a pause takes up to 140
/// cycles), then asleep.
unsigned wait_for_change(const std::atomic<unsigned>& value, unsigned old) {
  for (int turn = 0; turn < 400; ++turn) {
    const unsigned now = value.load(std::memory_order_acquire);
    if (now != old) return now;
#ifdef __SSE2__
    _mm_pause();
#endif
  }
  value.wait(old, std::memory_order_acquire);
  return value.load(std::memory_order_acquire);
}

/// The threads of run_on_threads(): worker i runs task i + 1.
class Pool {
 public:
  explicit Pool(int workers) {
    for (int i = 0; i < workers; ++i) threads_.emplace_back([this, i] { work(i + 1); });
  }
  ~Pool() {
    leaving_ = true;
    announce();
    for (std::thread& t : threads_) t.join();
  }
  int workers() const { return int(threads_.size()); }

  void run(const std::function<void(int)>& task) {
    task_ = &task;
    left_.store(unsigned(workers()), std::memory_order_relaxed);
    announce();
    guarded(0);
    for (unsigned left = left_.load(std::memory_order_acquire); left != 0;)
      left = wait_for_change(left_, left);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  }

 private:
  void announce() {
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
  }
  /// The first exception of any thread is rethrown on the calling thread.
  void guarded(int i) {
    inside_task = true;
    try {
      (*task_)(i);
    } catch (...) {
      const std::lock_guard lock(failing_);
      if (!failure_) failure_ = std::current_exception();
    }
    inside_task = false;
  }
  void work(int i) {
    flush_denormals();
    for (unsigned round = 0;;) {
      round = wait_for_change(round_, round);
      if (leaving_) return;
      guarded(i);
      if (left_.fetch_sub(1, std::memory_order_acq_rel) == 1) left_.notify_one();
    }
  }

  std::vector<std::thread> threads_;
  std::atomic<unsigned> round_{0}, left_{0};
  std::atomic<bool> leaving_{false};
  std::mutex failing_;
  std::exception_ptr failure_;
  const std::function<void(int)>* task_ = nullptr;
};

}  // namespace

int threads() { return thread_count(); }
void set_threads(int n) { thread_count() = n < 1 ? 1 : n; }

void flush_denormals() {
#ifdef __SSE2__
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  _mm_setcsr(_mm_getcsr() | flush_to_zero | denormals_are_zero);
#endif
}

void run_on_threads(int n, const std::function<void(int)>& task) {
  static std::unique_ptr<Pool> pool;
  if (n <= 1 || inside_task) {
    for (int i = 0; i < std::max(n, 1); ++i) task(i);
    return;
  }
  if (!pool || pool->workers() != n - 1) pool = std::make_unique<Pool>(n - 1);
  pool->run(task);
}

}  // namespace femsph
