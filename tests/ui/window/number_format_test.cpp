#include "ui/window/number_format.h"

#include <gtest/gtest.h>

#include "ui/window/number_text.h"

namespace kerf {
namespace {

TEST(NumberFormat, is_followed_by_a_text_as_it_is) {
  EXPECT_STREQ(RealFormat("%.3g %%").c_str(), "%.3g %%");
  EXPECT_EQ(RealFormat("%.3g ").with("% of mm"), "%.3g %% of mm");
  EXPECT_EQ(WholeFormat("%d").with(""), "%d");
}

TEST(NumberFormat, of_a_text_shows_the_text) {
  EXPECT_EQ(format_of_text("12 % of 40"), "12 %% of 40");
  EXPECT_EQ(format_of_text(""), "");
}

TEST(TextOf, takes_several_values) {
  EXPECT_EQ(text_of("%.0f %% of %zu %s", 12.4, size_t{40}, "faces"), "12 % of 40 faces");
  EXPECT_EQ(text_of("%s", std::string(300, 'x').c_str()), std::string(255, 'x'));
}

}  // namespace
}  // namespace kerf
