#include "model/numerics/parallel.hpp"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace femsph {

namespace {
int& thread_count() {
  static int n = 1;
  return n;
}
}  // namespace

int threads() { return thread_count(); }
void set_threads(int n) { thread_count() = n < 1 ? 1 : n; }

void flush_denormals() {
#ifdef __SSE2__
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
#pragma omp parallel num_threads(threads())
  _mm_setcsr(_mm_getcsr() | flush_to_zero | denormals_are_zero);
#endif
}

}  // namespace femsph
