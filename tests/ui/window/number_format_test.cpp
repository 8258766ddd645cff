#include "ui/window/number_text.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(NumberFormat, extracts_the_unit_after_the_number) {
  EXPECT_EQ(RealFormat("%.1f MB").unit(), "MB");
  EXPECT_EQ(RealFormat("%.4g J/(kg K)").unit(), "J/(kg K)");
  EXPECT_EQ(RealFormat("%.0f %%").unit(), "%");
  EXPECT_EQ(RealFormat("%.4g ").unit(), "");
  EXPECT_EQ(RealFormat("%g").unit(), "");
}

TEST(TextOf, formats_several_values) {
  EXPECT_EQ(text_of("%.0f %% of %zu %s", 12.4, size_t{40}, "faces"), "12 % of 40 faces");
  EXPECT_EQ(text_of("%s", std::string(300, 'x').c_str()), std::string(255, 'x'));
}

}  // namespace
}  // namespace kerf
