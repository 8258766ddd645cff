#include "ui/editor/laser/laser_feature.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace kerf {
namespace {

constexpr Area kPicture{{10, 30}, {900, 700}};
const Vec2 kSize(300, 90);

std::optional<Area> place_beside(const Area& taken) {
  const std::array corners{taken.at, taken.at + Vec2(taken.size.x, 0), taken.at + Vec2(0, taken.size.y),
                           taken.at + taken.size};
  return free_place(kPicture, kSize, 20, [&](const Area& area) { return !meets_hull(area, corners); });
}

TEST(HintBox, stays_at_the_bottom_centre_and_avoids_occupied_areas) {
  EXPECT_EQ(place_beside({{0, 0}, {5, 5}})->at, Vec2(310, 620));
  EXPECT_EQ(place_beside({{400, 640}, {10, 10}})->at, Vec2(30, 620));
  EXPECT_EQ(place_beside({{10, 200}, {900, 530}})->at, Vec2(310, 50));
  EXPECT_FALSE(place_beside(kPicture));
  EXPECT_FALSE(free_place(kPicture, {2000, 90}, 20, [](const Area&) { return true; }));
}

TEST(HintBox, a_triangle_is_tested_by_its_hull_not_its_bounding_box) {
  const std::array<Vec2, 3> points{Vec2(0, 0), Vec2(100, 0), Vec2(0, 100)};
  EXPECT_FALSE(meets_hull({{70, 70}, {30, 30}}, points));
  EXPECT_TRUE(meets_hull({{40, 40}, {30, 30}}, points));
}

TEST(HintBox, covers_no_point_of_a_box_from_any_eye_point) {
  Random random(5);
  size_t placed = 0;
  for (int i = 0; i < 300; ++i) {
    const auto somewhere = [&](double size) {
      const double x = random.uniform(-size, size), y = random.uniform(-size, size);
      return Vec3(x, y, random.uniform(-size, size));
    };
    const Vec3 half = glm::abs(somewhere(1));
    const CameraView view = look_at(somewhere(6), somewhere(0.5), kPicture.size.x / kPicture.size.y);
    const auto corners = seen_corners({-half, half}, view, kPicture);
    if (!corners) continue;
    const auto place =
        free_place(kPicture, kSize, 20, [&](const Area& area) { return !meets_hull(area, *corners); });
    placed += place.has_value();
    for (int k = 0; place && k < 50; ++k) {
      const Vec3 seen = view.project(somewhere(1) * half);
      const Vec2 at = kPicture.at + Vec2(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y) * kPicture.size;
      EXPECT_FALSE(place->contains(at)) << i;
    }
  }
  EXPECT_GT(placed, 50u);
}

}  // namespace
}  // namespace kerf
