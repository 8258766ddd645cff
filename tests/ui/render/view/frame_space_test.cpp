#include "ui/render/view/camera.h"

#include <gtest/gtest.h>

#include <limits>

namespace kerf {
namespace {

const World::Bounds kBox{{-1, 0, -1}, {1, 1, 1}};
constexpr double kNoGround = -1e9;

TEST(NearPlane, lies_just_in_front_of_all_visible_geometry) {
  const CameraView view = look_at({3, 2, 6}, {0, 0.5, 0}, 1.5);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner(i & 1 ? 1 : -1, i & 2 ? 1 : 0, i & 4 ? 1 : -1);
    least = std::min(least, glm::dot(corner - view.eye, view.forward));
  }
  const double near = near_plane(view, kBox, kNoGround);
  EXPECT_LT(near, least);
  EXPECT_GT(near, 0.5 * least);
}

// The ground at the lower border of the picture is nearer than the box.
TEST(NearPlane, lies_in_front_of_the_visible_ground) {
  for (const Vec3& eye : {Vec3(3, 2, 6), Vec3(0, 0.4, 5), Vec3(0, 5, 0.5)}) {
    const CameraView view = look_at(eye, {0, 0.5, 0}, 1.5);
    const double near = near_plane(view, kBox, -0.1);
    for (const double x : {-1.0, 0.0, 1.0}) {
      const Pose ray = view.ray(x, -1);
      if (ray.direction.y >= 0) continue;
      const double length = (-0.1 - view.eye.y) / ray.direction.y;
      EXPECT_LT(near, length * glm::dot(ray.direction, view.forward));
    }
  }
}

TEST(NearPlane, is_a_fraction_of_the_focus_distance_inside_the_box) {
  const CameraView view = look_at({0, 0.5, 0.2}, {0, 0.5, -1.8}, 1.5);
  EXPECT_DOUBLE_EQ(near_plane(view, kBox, kNoGround), 0.008);
}

// Of every kind of view, also on the way from one kind to the other.
TEST(FrameSpace, the_matrix_projects_like_the_view_with_buffer_depths) {
  const CameraView close = look_at({3, 2, 6}, {0, 0.5, 0}, 1.5);
  for (const double pull : {1.0, 4.0, 200.0, CameraView::kFarAway}) {
    CameraView view = close.pulled(pull);
    view.up_axis = pull < 100 ? UpAxis::kY : UpAxis::kZ;
    const double near = near_plane(view, kBox, -0.1);
    FrameSpace space;
    space.eye = close.eye;
    space.unit = 2;
    space.up = view.up_axis;
    const glm::mat4 clip = uniforms_of(view, near, space, 600, 400).clip_from_frame;
    for (const Vec3& p : {Vec3(0, 0.5, 0), Vec3(-1, 1, 1), Vec3(0.9, 0, -1)}) {
      const glm::vec4 seen = clip * glm::vec4(space.from_world(p), 1);
      const Vec3 expected = view.project(p);
      EXPECT_NEAR(seen.x / seen.w, expected.x, 1e-4) << pull;
      EXPECT_NEAR(seen.y / seen.w, expected.y, 1e-4) << pull;
      const double depth = window_depth(view, near, expected.z);
      EXPECT_NEAR(0.5 + 0.5 * seen.z / seen.w, depth, 1e-4) << pull;
      EXPECT_GT(depth, 0) << pull;
      EXPECT_LT(depth, 1) << pull;
    }
  }
}

}  // namespace
}  // namespace kerf
