// Replaces operator new in a program of this project: aligns large arrays to huge pages and backs
// them by these if the system has any. Loading a million faces fills several hundred megabytes, and page
// faults of small pages take a fifth of that time.
#include <cstdlib>
#include <new>

#include "core/base/records.h"

namespace {

void* allocate(size_t bytes) {
  if (bytes < kerf::kHugePage) return std::malloc(bytes > 0 ? bytes : 1);
  const size_t whole = (bytes + kerf::kHugePage - 1) / kerf::kHugePage * kerf::kHugePage;
  void* memory = whole < bytes ? nullptr : std::aligned_alloc(kerf::kHugePage, whole);
  // The last page becomes a huge page only if most of it is used.
  const size_t rest = bytes % kerf::kHugePage;
  const size_t advised = rest == 0 || rest > kerf::kHugePage / 2 ? whole : whole - kerf::kHugePage;
  if (memory) kerf::advise_huge_pages(memory, advised);
  return memory;
}

}  // namespace

// Not inlined: if the compiler saw malloc here, it would report the matching operator delete as a mismatch.
[[gnu::noinline]] void* operator new(size_t bytes) {
  for (;;) {
    if (void* memory = allocate(bytes)) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (!handler) throw std::bad_alloc();
    handler();
  }
}

[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, size_t) noexcept { std::free(memory); }
