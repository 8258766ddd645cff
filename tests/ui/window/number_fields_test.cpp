#include "ui/window/number_fields.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(NumberFields, read_a_count_with_and_without_grouped_digits) {
  EXPECT_EQ(count_in("31841"), 31'841u);
  EXPECT_EQ(count_in("31 841"), 31'841u);
  EXPECT_EQ(count_in("1e4"), 10'000u);
  for (const char* wrong : {"", "0", "-3", "many", "3 faces", "1e99", "nan"})
    EXPECT_FALSE(count_in(wrong).has_value()) << wrong;
}

}  // namespace
}  // namespace kerf
