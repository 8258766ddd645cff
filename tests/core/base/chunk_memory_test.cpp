#include "core/base/records.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace kerf {
namespace {

TEST(ChunkMemory, is_zeroed_aligned_and_not_shared) {
  const size_t bytes = 3 * kHugePage;
  auto* first = static_cast<unsigned char*>(allocate_chunk(bytes));
  auto* second = static_cast<unsigned char*>(allocate_chunk(bytes));
  for (const unsigned char* chunk : {first, second}) {
    EXPECT_EQ(reinterpret_cast<uintptr_t>(chunk) % kHugePage, 0u);
    for (size_t at = 0; at < bytes; at += 4096) ASSERT_EQ(chunk[at], 0);
  }
  advise_huge_pages(first, bytes);
  for (size_t at = 0; at < bytes; at += 4096) first[at] = 7;
  EXPECT_EQ(second[0], 0);
  EXPECT_EQ(second[bytes - 1], 0);
  free_chunk(first, bytes);
  free_chunk(second, bytes);
}

}  // namespace
}  // namespace kerf
