#include "ui/screen/live_picture.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(PictureRest, begins_shortly_after_the_last_change) {
  PictureRest rest;
  rest.follow(PictureChange::kAll, 10);
  EXPECT_FALSE(rest.rests());
  EXPECT_FALSE(rest.shapes_rest());
  rest.follow(PictureChange::kNothing, 10.1);
  EXPECT_FALSE(rest.rests());
  rest.follow(PictureChange::kNothing, 10.2);
  EXPECT_TRUE(rest.rests());
  EXPECT_TRUE(rest.shapes_rest());
}

TEST(PictureRest, of_shapes_is_not_interrupted_by_cooling) {
  PictureRest rest;
  rest.follow(PictureChange::kAll, 10);
  for (int frame = 1; frame <= 60; ++frame) {
    rest.follow(PictureChange::kHeat, 10 + frame / 60.0);
    EXPECT_FALSE(rest.rests());
  }
  EXPECT_TRUE(rest.shapes_rest());
  rest.follow(PictureChange::kAll, 11.1);
  EXPECT_FALSE(rest.shapes_rest());
}

}  // namespace
}  // namespace kerf
