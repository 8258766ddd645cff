#include <gtest/gtest.h>

#include "core/base/number_format.h"

namespace kerf {
namespace {

TEST(LengthText, selects_the_unit) {
  EXPECT_EQ(length_text(0.01225), "12.2 mm");
  EXPECT_EQ(length_text(3), "3 m");
  EXPECT_EQ(length_text(0.9994), "999 mm");
  EXPECT_EQ(length_text(0.9996), "1 m");
  EXPECT_EQ(length_text(-9.997e-4), "-1 mm");
}

}  // namespace
}  // namespace kerf
