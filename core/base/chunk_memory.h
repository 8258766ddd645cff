#pragma once

#include <cstddef>

namespace kerf {

// Memory for large arrays that grow by chunks: whole pages from the system, zero, which cost nothing until
// they are written. A chunk starts on a boundary of kHugePage.
inline constexpr size_t kHugePage = size_t{2} << 20;

// `bytes` is a multiple of kHugePage. Throws std::bad_alloc.
void* take_chunk(size_t bytes);
void give_chunk(void* chunk, size_t bytes);

// Asks the system to back the chunk with huge pages, which spares misses of the TLB. Only a hint.
void advise_huge_pages(void* chunk, size_t bytes);

}  // namespace kerf
