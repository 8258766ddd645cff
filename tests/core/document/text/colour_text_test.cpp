#include "core/document/scene.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace kerf {
namespace {

TEST(ColourText, round_trips_every_value) {
  for (int step = 0; step < 256; ++step) {
    char text[32];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<unsigned>(step),
                  255u - static_cast<unsigned>(step), 7u);
    const auto colour = parse_colour(text);
    ASSERT_TRUE(colour.has_value());
    EXPECT_EQ(colour_text(*colour), text);
  }
  for (const char* wrong : {"", "#12345", "#1234567", "1234567", "#12345g", "#-12345"})
    EXPECT_FALSE(parse_colour(wrong).has_value()) << wrong;
}

}  // namespace
}  // namespace kerf
