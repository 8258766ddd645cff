#include "core/laser/laser.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

TEST(Subdivide, covers_pose_to_pose_in_segments_no_longer_than_the_radius) {
  Random random(17);
  for (int i = 0; i < 200; ++i) {
    const Pose from{random_direction(random), random_direction(random)};
    const Pose to{random_direction(random),
                  glm::normalize(from.direction + 1.5 * random.unit() * random_direction(random))};
    const double radius = random.uniform(0.01, 0.3), reach = random.uniform(0.5, 4);
    const double seconds = random.uniform(0, 3);
    const auto moves = subdivide({from, to, seconds}, radius, reach);
    EXPECT_EQ(moves.front().from.origin, from.origin);
    EXPECT_EQ(moves.back().to.origin, to.origin);
    EXPECT_EQ(moves.back().to.direction, to.direction);
    for (size_t k = 0; k < moves.size(); ++k) {
      const BeamMove& m = moves[k];
      EXPECT_EQ(m.seconds * static_cast<double>(moves.size()), seconds);  // 2^k equal shares are exact
      if (k > 0) EXPECT_EQ(m.from.origin, moves[k - 1].to.origin);
      if (k > 0) EXPECT_EQ(m.from.direction, moves[k - 1].to.direction);
      for (const double depth : {0.0, reach}) {
        const Vec3 way = (m.to.origin + depth * m.to.direction) - (m.from.origin + depth * m.from.direction);
        EXPECT_LE(glm::length(way), radius * (1 + 1e-9));
      }
    }
  }
}

TEST(Subdivide, rotates_evenly_along_the_shorter_arc) {
  const Pose from{{0, 0, 0}, {1, 0, 0}}, to{{0, 0, 0}, glm::normalize(Vec3(-0.5, 1, 0))};
  const auto moves = subdivide({from, to}, 0.1, 1);
  const double step = std::acos(glm::dot(from.direction, to.direction)) / static_cast<double>(moves.size());
  for (const BeamMove& m : moves) {
    EXPECT_NEAR(std::acos(std::min(1.0, glm::dot(m.from.direction, m.to.direction))), step, 1e-7);
    EXPECT_NEAR(m.to.direction.z, 0, 1e-15);
    EXPECT_NEAR(glm::length(m.to.direction), 1, 1e-15);
  }
}

TEST(Subdivide, keeps_a_constant_direction_bit_identical) {
  const Vec3 d = glm::normalize(Vec3(0.05, -1, 0.02));
  for (const BeamMove& m : subdivide({{{0, 0, 0}, d}, {{1, 0, 0.3}, d}}, 0.01, 5)) {
    EXPECT_EQ(m.from.direction, d);
    EXPECT_EQ(m.to.direction, d);
  }
}

TEST(SweepBeam, places_four_rays_on_a_circle_of_the_radius) {
  Laser laser;
  laser.radius = 0.3;
  laser.range = {0, 9};
  laser.pattern = Pattern::kRays4;
  const Pose pose{{0, 0, 5}, {0, 0, -1}};
  const auto rays = sweep_beam(laser, {pose, pose});
  ASSERT_EQ(rays.size(), 4u);
  int touched = 0;
  for (const SweptCylinder& ray : rays) {
    EXPECT_EQ(ray.radius(), 0);
    const auto small = [](Vec3 c) {
      return Triangle{c + Vec3(-0.01, -0.01, 0), c + Vec3(0.01, -0.01, 0), c + Vec3(0, 0.02, 0)};
    };
    for (const Vec3& at : {Vec3(0.3, 0, 0), Vec3(-0.3, 0, 0), Vec3(0, 0.3, 0), Vec3(0, -0.3, 0)})
      touched += ray.touches(small(at));
    EXPECT_FALSE(ray.touches(small(Vec3(0))));
  }
  EXPECT_EQ(touched, 4);
}

}  // namespace
}  // namespace kerf::test
