#include "ui/render/view/camera.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "ui/render/passes/beam_effects.h"

namespace kerf {
namespace {

constexpr int kScreenWidth = 640, kScreenHeight = 360;
constexpr double kMargin = 40;

CameraView some_view(Random& random) {
  const auto point = [&](double size) {
    return Vec3(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
  };
  return look_at(point(5), point(2), double{kScreenWidth} / kScreenHeight);
}

Vec2 pixel_of(const CameraView& view, const Vec3& p) {
  const Vec3 seen = view.project(p);
  return Vec2((seen.x + 1) * 0.5 * kScreenWidth, (seen.y + 1) * 0.5 * kScreenHeight);
}

bool in_picture(const Vec2& p) { return p.x >= 0 && p.y >= 0 && p.x <= kScreenWidth && p.y <= kScreenHeight; }

double distance_to_line(const Vec2& p, const ScreenSegment& s) {
  const Vec2 way = s.to - s.from;
  const double length = glm::length(way);
  return length > 1e-9 ? std::abs(cross2(way, p - s.from)) / length : glm::length(p - s.from);
}

TEST(ScreenSegment, contains_all_visible_points_and_ends_within_the_margin) {
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const CameraView close = some_view(random);
    const CameraView view = seed % 4 == 0 ? close.pulled(CameraView::kFarAway) : close;
    // Near the eye, through its plane, and far away.
    const double size = seed % 3 == 0 ? 0.5 : 20;
    const auto point = [&] {
      return close.eye + size * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    const Vec3 from = point(), to = point();
    const auto seen = on_screen(view, from, to, kScreenWidth, kScreenHeight, kMargin);
    for (int i = 0; i <= 200; ++i) {
      const double share = i / 200.0;
      const Vec3 p = from + share * (to - from);
      const bool behind = !view.parallel && glm::dot(p - view.eye, view.forward) < 1e-3 * view.focus;
      if (behind || !in_picture(pixel_of(view, p))) continue;
      ASSERT_TRUE(seen.has_value());
      EXPECT_GE(share, seen->share.x - 1e-9);
      EXPECT_LE(share, seen->share.y + 1e-9);
      EXPECT_LT(distance_to_line(pixel_of(view, p), *seen), 1e-6);
    }
    if (!seen) continue;
    for (const Vec2& end : {seen->from, seen->to}) {
      EXPECT_LE(std::abs(end.x - 0.5 * kScreenWidth), 0.5 * kScreenWidth + kMargin + 1e-6);
      EXPECT_LE(std::abs(end.y - 0.5 * kScreenHeight), 0.5 * kScreenHeight + kMargin + 1e-6);
    }
  }
}

TEST(BeamPicture, ends_on_the_ground_only_where_it_hits) {
  const BeamPicture down{{0, 2, 0}, {4, -2, 0}, std::nullopt, 0.01};
  const BeamPicture landed = ended_on_ground(down, 0);
  EXPECT_TRUE(landed.on_ground);
  EXPECT_LT(glm::length(landed.to - Vec3(2, 0, 0)), 1e-12);
  EXPECT_FALSE(ended_on_ground(down, -3).on_ground);
  EXPECT_FALSE(ended_on_ground({{0, 2, 0}, {4, 3, 0}, std::nullopt, 0.01}, 0).on_ground);
  EXPECT_FALSE(ended_on_ground({{0, -1, 0}, {4, -3, 0}, std::nullopt, 0.01}, 0).on_ground);
}

}  // namespace
}  // namespace kerf
