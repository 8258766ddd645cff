#include <gtest/gtest.h>

#include "ui/editor/shared/viewport.h"

namespace kerf {
namespace {

TEST(CameraText, round_trips) {
  const View view{{1.0 / 3, 2, -3e-7}, {0, 0.5, 0}};
  const auto parsed = parse_view_text(view_text(view));
  ASSERT_TRUE(parsed.ok());
  EXPECT_EQ(parsed->eye, view.eye);
  EXPECT_EQ(parsed->target, view.target);
}

TEST(CameraText, accepts_a_scene_and_rejects_invalid_views) {
  EXPECT_TRUE(parse_view_text(R"({"view": {"eye": [1,2,3], "target": [0,0,0]}})").ok());
  for (const char* text : {"", "hello", "{}", "[1]", R"({"eye": [1,2], "target": [0,0,0]})",
                           R"({"eye": [1,2,3], "target": [1,2,3]})"}) {
    EXPECT_FALSE(parse_view_text(text).ok()) << text;
  }
}

}  // namespace
}  // namespace kerf
