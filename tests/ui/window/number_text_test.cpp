#include <gtest/gtest.h>

#include "ui/window/number_text.h"

namespace kerf {
namespace {

TEST(NumberText, groups_digits_and_chooses_the_unit_of_area) {
  EXPECT_EQ(grouped(12345678), "12 345 678");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(area_text(0), "none");
  EXPECT_EQ(area_text(6.27), "6.27 m\xc2\xb2");
  EXPECT_EQ(area_text(0.00041), "4.1 cm\xc2\xb2");
}

}  // namespace
}  // namespace kerf
