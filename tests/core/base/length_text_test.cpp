#include <gtest/gtest.h>

#include "core/base/number_format.h"

namespace kerf {
namespace {

TEST(LengthText, selects_the_unit) {
  EXPECT_EQ(length_text(0.01225), "12.2 mm");
  EXPECT_EQ(length_text(3), "3 m");
}

}  // namespace
}  // namespace kerf
