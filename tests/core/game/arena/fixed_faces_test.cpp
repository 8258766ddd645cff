#include "core/game/arena/arena.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/deterministic_math.h"
#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

TEST(FixedFaces, are_the_faces_of_pinned_bodies_in_world_space) {
  Arena arena;
  for (const bool pinned : {true, false}) {
    Body& body = arena.bodies.emplace_back().body;
    body = make_body("plate", test::build(test::plate(1)));
    body.pinned = pinned;
    body.placement = {{5, 2, 0}, axis_angle({1, 0, 0}, kPi / 2)};
  }
  const std::vector<Triangle> faces = fixed_faces(arena);
  ASSERT_EQ(faces.size(), 2u);
  const Body& body = arena.bodies[0].body;
  for (int corner = 0; corner < 3; ++corner) {
    EXPECT_EQ(faces[0][corner], body.placement.to_world(body.mesh.triangle(FaceId(0))[corner]));
    EXPECT_NEAR(faces[0][corner].z, 0, 1e-12) << "it stands upright";
  }
}

// A triangle that rises by an angle.
Triangle slope(double degrees, double size = 1) {
  const SinCos a = sin_cos(radians_of(degrees));
  return {Vec3(0), Vec3(0, 0, size), size * Vec3(a.cos, a.sin, 0)};
}

TEST(FixedFaces, are_drivable_up_to_45_degrees_from_either_side_at_any_size) {
  for (const double size : {1e-3, 1.0, 1e3}) {
    EXPECT_TRUE(is_drivable(slope(0, size)));
    EXPECT_TRUE(is_drivable(slope(45, size)));
    EXPECT_FALSE(is_drivable(slope(46, size)));
    EXPECT_FALSE(is_drivable(slope(90, size)));
    EXPECT_TRUE(is_drivable(slope(180 - 45, size)));
  }
  EXPECT_FALSE(is_drivable({Vec3(0), Vec3(1, 0, 0), Vec3(2, 0, 0)})) << "it has no area";
}

}  // namespace
}  // namespace kerf
