#include "core/base/records.h"

#include <sys/mman.h>

#include "core/base/assert.h"

namespace kerf {

void* allocate_chunk(size_t bytes) {
  KERF_ASSERT(bytes > 0 && bytes % kHugePage == 0);
  // Maps one huge page more than requested and unmaps both ends, so that the remainder is aligned.
  const size_t taken = bytes + kHugePage;
  void* start =
      mmap(nullptr, taken, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (start == MAP_FAILED) throw std::bad_alloc();
  const auto first = reinterpret_cast<uintptr_t>(start);
  const uintptr_t aligned = (first + kHugePage - 1) / kHugePage * kHugePage;
  if (aligned > first) munmap(start, aligned - first);
  const uintptr_t end = aligned + bytes;
  if (first + taken > end) munmap(reinterpret_cast<void*>(end), first + taken - end);
  return reinterpret_cast<void*>(aligned);
}

void free_chunk(void* chunk, size_t bytes) {
  KERF_ASSERT(reinterpret_cast<uintptr_t>(chunk) % kHugePage == 0 && bytes % kHugePage == 0);
  munmap(chunk, bytes);
}

void advise_huge_pages([[maybe_unused]] void* chunk, [[maybe_unused]] size_t bytes) {
#ifdef MADV_HUGEPAGE
  if (bytes > 0) madvise(chunk, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace kerf
