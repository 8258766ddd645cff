#include "core/document/stroke_path.h"

#include <gtest/gtest.h>

#include "core/base/ids.h"

namespace kerf::test {
namespace {

constexpr Vec3 kDown(0, -1, 0);

StrokePath bent() {
  StrokePath stroke;
  for (const Vec3& at : {Vec3(0, 1, 0), Vec3(3, 1, 0), Vec3(3, 1, 4)}) stroke.keys.push_back({at, kDown});
  stroke.times = {0, 1, 7};
  return stroke;
}

TEST(EditPath, a_speed_sets_the_duration_of_each_segment) {
  StrokePath stroke = bent();
  EXPECT_EQ(way_of(stroke), 7);
  EXPECT_EQ(duration_of(stroke), 7);
  retime(stroke, 2);
  EXPECT_EQ(stroke.times, (std::vector<double>{0, 1.5, 3.5}));
}

TEST(EditPath, a_beam_turning_in_place_takes_one_tick) {
  StrokePath stroke;
  stroke.keys = {{Vec3(0), kDown}, {Vec3(0), {1, 0, 0}}};
  retime(stroke, 2);
  EXPECT_EQ(stroke.times, (std::vector<double>{0, seconds_of_ticks(1)}));
}

TEST(EditPath, inserted_keys_keep_times_ascending) {
  StrokePath stroke = bent();
  insert_key(stroke, 1, {{1, 1, 0}, kDown});
  insert_key(stroke, 4, {{3, 1, 6}, kDown});
  insert_key(stroke, 0, {{-1, 1, 0}, kDown});
  EXPECT_EQ(stroke.times, (std::vector<double>{-1, 0, 0.5, 1, 7, 9}));
  erase_key(stroke, 0);
  EXPECT_EQ(stroke.times.front(), 0);
  EXPECT_EQ(stroke.keys.size(), 5u);
  stroke.times = {0, 1, std::nextafter(1.0, 2.0), 3, 4};
  insert_key(stroke, 2, {{2, 1, 0}, kDown});
  EXPECT_TRUE(std::is_sorted(stroke.times.begin(), stroke.times.end(), std::less_equal<>()));
}

TEST(EditPath, opposite_neighbours_are_rejected_by_name) {
  StrokePath stroke = bent();
  EXPECT_TRUE(rejection_reason({}).has_value());
  EXPECT_FALSE(rejection_reason(std::vector{stroke}).has_value());
  stroke.keys.back().direction = -kDown;
  const auto why = rejection_reason(std::vector{bent(), stroke});
  ASSERT_TRUE(why.has_value());
  EXPECT_NE(why->find("Points 2 and 3 of stroke 2"), std::string::npos) << *why;
}

TEST(EditPath, strokes_with_too_few_points_are_rejected_like_their_file) {
  StrokePath dot = bent();
  while (dot.keys.size() > 1) erase_key(dot, 1);
  EXPECT_FALSE(rejection_reason(std::vector{dot}).has_value());
  dot.radius = 0;
  for (const StrokePath& stroke : {dot, StrokePath()}) {
    const std::vector<StrokePath> strokes{bent(), stroke};
    EXPECT_FALSE(read_path_text(path_file_text(strokes), "test").ok());
    const auto why = rejection_reason(strokes);
    ASSERT_TRUE(why.has_value());
    EXPECT_NE(why->find("Stroke 2"), std::string::npos) << *why;
  }
}

}  // namespace
}  // namespace kerf::test
