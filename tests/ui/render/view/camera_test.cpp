#include "ui/render/view/camera.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

const World::Bounds kCar{{-0.9, 0, -2.1}, {0.9, 1.45, 2.1}};
constexpr double kWide = 16.0 / 9;

Camera framed() {
  Camera camera;
  camera.frame_default(kCar, kWide);
  camera.finish();
  return camera;
}

TEST(Camera, ray_through_a_pixel_hits_the_point_projected_there) {
  const CameraView view = framed().view(kWide);
  const Vec3 p(0.3, 0.8, 1.1);
  const Vec3 seen = view.project(p);
  const Pose ray = view.ray(seen.x, seen.y);
  const Vec3 again = ray.origin + ray.direction * glm::length(p - view.eye);
  EXPECT_LT(glm::length(again - p), 1e-12);
}

TEST(Camera, first_view_is_from_the_front_and_above_at_half_the_height) {
  const CameraView view = framed().view(kWide);
  EXPECT_GT(view.eye.z, 2.1);
  EXPECT_GT(view.eye.y, 0.5);
  double low = 1, high = -1;
  for (int corner = 0; corner < 8; ++corner) {
    const double y =
        view.project({corner & 1 ? 0.9 : -0.9, corner & 2 ? 1.45 : 0, corner & 4 ? 2.1 : -2.1}).y;
    low = std::min(low, y);
    high = std::max(high, y);
  }
  EXPECT_GT(high - low, 1.0);
  EXPECT_LT(high - low, 1.4);
}

TEST(Camera, orbit_stops_at_the_poles) {
  Camera camera = framed();
  camera.orbit(0, 100);
  camera.finish();
  const CameraView view = camera.view(kWide);
  EXPECT_LT(view.forward.y, -0.99);
  EXPECT_GT(view.up.y, 0);
}

TEST(Camera, pan_moves_points_at_the_pivot_depth_with_the_pointer) {
  Camera camera = framed();
  const Vec3 pivot = camera.pivot();
  camera.pan(0.25, -0.5, kWide);
  camera.finish();
  const Vec3 seen = camera.view(kWide).project(pivot);
  EXPECT_NEAR(seen.x, 0.25, 1e-12);
  EXPECT_NEAR(seen.y, -0.5, 1e-12);
}

TEST(Camera, zoom_keeps_the_point_under_the_pointer) {
  Camera camera = framed();
  const CameraView before = camera.view(kWide);
  const Pose ray = before.ray(0.4, 0.3);
  const Vec3 under = ray.origin + ray.direction * (before.focus / glm::dot(ray.direction, before.forward));
  camera.zoom(0.5, 0.4, 0.3, kWide);
  camera.finish();
  const CameraView after = camera.view(kWide);
  EXPECT_NEAR(after.focus, before.focus / 2, 1e-12);
  EXPECT_NEAR(after.project(under).x, 0.4, 1e-12);
  EXPECT_NEAR(after.project(under).y, 0.3, 1e-12);
}

TEST(Camera, eases_to_its_target) {
  Camera camera = framed();
  const double start = camera.view(kWide).focus;
  camera.zoom(0.5, 0, 0, kWide);
  EXPECT_TRUE(camera.advance(0.016));
  EXPECT_LT(camera.view(kWide).focus, start);
  EXPECT_GT(camera.view(kWide).focus, start / 2);
  int frames = 0;
  while (camera.advance(0.016)) ASSERT_LT(++frames, 60);
  EXPECT_EQ(camera.view(kWide).focus, start / 2);
}

TEST(Camera, frames_worlds_of_any_size) {
  for (const double size : {1e-6, 1.0, 1e6, 1e39}) {
    Camera camera;
    camera.frame_default({kCar.min * size, kCar.max * size}, kWide);
    camera.finish();
    EXPECT_NEAR(camera.view(kWide).focus / size, framed().view(kWide).focus, 1e-6) << size;
  }
}

TEST(Camera, an_orthographic_view_shows_equal_lengths_at_all_distances) {
  Camera camera = framed();
  const CameraView before = camera.view(kWide);
  camera.set_parallel(true);
  camera.finish();
  const CameraView view = camera.view(kWide);
  EXPECT_TRUE(view.parallel);
  const Vec3 pivot = camera.pivot();
  for (const double depth : {-3.0, 0.0, 3.0}) {
    const Vec3 at = pivot + view.forward * depth;
    const double length = view.project(at + view.up * 0.5).y - view.project(at).y;
    EXPECT_NEAR(length, before.project(pivot + before.up * 0.5).y - before.project(pivot).y, 1e-9) << depth;
  }
  const Vec3 p(0.3, 0.8, 1.1), seen = view.project(p);
  const Pose ray = view.ray(seen.x, seen.y);
  EXPECT_LT(glm::length(ray.origin + ray.direction * seen.z - p), 1e-9);
  EXPECT_LT(glm::length(view.near().eye - before.eye), 1e-9);
  camera.set_parallel(false);
  camera.finish();
  EXPECT_LT(glm::length(camera.view(kWide).eye - before.eye), 1e-12);
}

TEST(Camera, eases_from_perspective_to_orthographic_without_a_jump) {
  Camera camera = framed();
  camera.set_parallel(true);
  const Vec3 corner(0.9, 1.45, 2.1);
  Vec3 last = camera.view(kWide).project(corner);
  int frames = 0;
  while (camera.advance(0.016)) {
    ASSERT_LT(++frames, 60);
    const Vec3 now = camera.view(kWide).project(corner);
    EXPECT_LT(glm::length(Vec2(now - last)), 0.1) << frames;
    last = now;
  }
  EXPECT_TRUE(camera.view(kWide).parallel);
}

TEST(Camera, keeps_another_up_axis) {
  const World::Bounds lying{{-0.9, -2.1, 0}, {0.9, 2.1, 1.45}};  // the car with +Z upwards, its front at -Y
  Camera camera;
  camera.set_up_axis(UpAxis::kZ);
  camera.frame_default(lying, kWide);
  camera.finish();
  const CameraView view = camera.view(kWide), usual = framed().view(kWide);
  EXPECT_LT(glm::length(to_y_up(view.eye, UpAxis::kZ) - usual.eye), 1e-9);
  EXPECT_LT(glm::length(to_y_up(view.up, UpAxis::kZ) - usual.up), 1e-12);
  camera.look(view.eye, camera.pivot());
  camera.finish();
  EXPECT_LT(glm::length(camera.view(kWide).eye - view.eye), 1e-9);
}

TEST(Camera, turns_the_shorter_way) {
  Camera camera = framed();
  camera.orbit(3.1, 0);
  camera.finish();
  camera.turn_to(-1.5707963267948966, 0);
  camera.advance(0.001);
  EXPECT_TRUE(camera.is_turned_to(-1.5707963267948966, 0));
  camera.finish();
  EXPECT_LT(glm::length(camera.view(kWide).forward - Vec3(1, 0, 0)), 1e-12);
  camera.turn_to(0, 1.5707963267948966);
  camera.finish();
  const CameraView top = camera.view(kWide);
  EXPECT_LT(glm::length(top.forward - Vec3(0, -1, 0)), 1e-12);
  EXPECT_LT(glm::length(top.right - Vec3(1, 0, 0)), 1e-12);
}

TEST(Camera, look_at_a_target_straight_below_is_valid) {
  const CameraView view = look_at({0, 5, 0}, {0, 0, 0}, kWide);
  EXPECT_NEAR(glm::length(view.right), 1, 1e-12);
  EXPECT_NEAR(glm::length(view.up), 1, 1e-12);
  EXPECT_NEAR(glm::dot(view.right, view.up), 0, 1e-12);
}

TEST(Camera, a_narrow_viewport_shows_as_much_horizontally_as_a_wider_one) {
  const Camera camera = framed();
  const auto sideways = [&](double aspect) {
    const CameraView view = camera.view(aspect);
    return view.tan_half_fov * view.aspect;
  };
  EXPECT_NEAR(sideways(0.6), sideways(1.0), 1e-12);
  EXPECT_LT(sideways(1.0), sideways(kWide));
}

}  // namespace
}  // namespace kerf
