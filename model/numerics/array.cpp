#include "model/numerics/array.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace femsph {

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;
std::align_val_t alignment(std::size_t bytes) {
  return std::align_val_t(bytes >= 2 * huge_page ? huge_page : 64);
}

}  // namespace

void* allocate_aligned(std::size_t bytes) {
  void* p = ::operator new(bytes, alignment(bytes));
#ifdef MADV_HUGEPAGE
  if (bytes >= 2 * huge_page)
    madvise(p, bytes / huge_page * huge_page,
            MADV_HUGEPAGE);  // a hint, without effect on results
#endif
  return p;
}

void release_aligned(void* p, std::size_t bytes) { ::operator delete(p, alignment(bytes)); }

}  // namespace femsph
