#include "core/mesh/files/encode.h"

#include <gtest/gtest.h>

#include "core/base/parallel.h"

namespace kerf {
namespace {

std::string numbers(size_t items) {
  std::string all;
  emit_ranges(
      items,
      [&](std::string_view part) {
        all += part;
        return true;
      },
      [](size_t first, size_t end, std::string& part) {
        for (size_t i = first; i < end; ++i) part += std::to_string(i) + ",";
      });
  return all;
}

TEST(EmitRanges, emits_all_items_in_order_for_any_thread_count) {
  for (const size_t items : {0u, 1u, 70'000u, 300'001u}) {
    std::string expected;
    for (size_t i = 0; i < items; ++i) expected += std::to_string(i) + ",";
    EXPECT_EQ(numbers(items), expected);
    const ThreadLimit alone(1);
    EXPECT_EQ(numbers(items), expected);
  }
}

TEST(EmitRanges, stops_when_the_sink_stops) {
  size_t parts = 0;
  const bool done = emit_ranges(
      1'000'000, [&](std::string_view) { return ++parts < 2; },
      [](size_t, size_t, std::string& part) { part += "x"; });
  EXPECT_FALSE(done);
  EXPECT_EQ(parts, 2u);
}

}  // namespace
}  // namespace kerf
