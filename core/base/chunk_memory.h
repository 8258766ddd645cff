#pragma once

#include <cstddef>

namespace kerf {

// Memory for large arrays that grow chunk by chunk. A chunk consists of whole pages from the system, is
// zero-initialised, is aligned to kHugePage bytes and takes no physical memory until it is written.
inline constexpr size_t kHugePage = size_t{2} << 20;

// Allocates and frees a chunk. Precondition: `bytes` is a positive multiple of kHugePage, the same number for
// both calls. take_chunk throws std::bad_alloc.
void* take_chunk(size_t bytes);
void give_chunk(void* chunk, size_t bytes);

// Asks the system to back the chunk with huge pages, which saves TLB misses. This is only a hint.
void advise_huge_pages(void* chunk, size_t bytes);

}  // namespace kerf
