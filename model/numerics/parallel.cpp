#include "model/numerics/parallel.hpp"

namespace femsph {

namespace {
int& thread_count() {
  static int n = 1;
  return n;
}
}  // namespace

int threads() { return thread_count(); }
void set_threads(int n) { thread_count() = n < 1 ? 1 : n; }

}  // namespace femsph
