#include "core/cut/stroke_region.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace kerf {
namespace {

// A beam straight down that moves along x, in pieces of 1 m.
class RegionAlongX : public testing::Test {
 protected:
  RegionAlongX() {
    for (int i = 0; i < 4; ++i) {
      const Vec3 down(0, -1, 0);
      region_.add(SweptCylinder({Vec3(i, 5, 0), down}, {Vec3(i + 1, 5, 0), down}, 0.5, {0, 10}));
    }
  }
  void note(FaceId f, std::initializer_list<uint32_t> parts) {
    for (const uint32_t part : parts) region_.record_near(f, part);
  }

  StrokeRegion region_;
};

TEST_F(RegionAlongX, evaluates_only_the_parts_listed_for_a_face) {
  EXPECT_FALSE(region_.is_near(FaceId(7)));
  note(FaceId(7), {0, 1});
  EXPECT_TRUE(region_.is_near(FaceId(7)));
  EXPECT_NEAR(region_.signed_distance(FaceId(7), {1.2, 0, 0.8}), 0.3, 1e-9);
  EXPECT_NEAR(region_.signed_distance(FaceId(7), {1.2, 0, 0.1}), -0.4, 1e-9);
  EXPECT_GT(region_.signed_distance(FaceId(7), {3.9, 0, 0}), 1) << "the other parts are not asked";
}

TEST_F(RegionAlongX, gives_children_the_parts_of_all_their_parents) {
  note(FaceId(1), {0});
  note(FaceId(2), {3});
  const std::vector<FaceId> children{FaceId(1), FaceId(2), FaceId(9)}, parents{FaceId(1), FaceId(2)};
  region_.inherit(children, parents);
  for (const FaceId f : children) {
    EXPECT_LT(region_.signed_distance(f, {0.5, 0, 0}), 0);
    EXPECT_LT(region_.signed_distance(f, {3.5, 0, 0}), 0);
  }
}

TEST_F(RegionAlongX, reaches_into_a_triangle_only_beyond_the_tolerance) {
  note(FaceId(0), {0, 1, 2, 3});
  const Triangle beside{Vec3(1, 0, 0.45), Vec3(2, 0, 0.45), Vec3(1.5, 0, 2)};
  EXPECT_TRUE(region_.reaches_into(FaceId(0), beside, 0.01));
  EXPECT_FALSE(region_.reaches_into(FaceId(0), beside, 0.1));
}

TEST(StrokeRegion, does_not_reach_into_triangles_that_the_range_has_left_behind) {
  const Vec3 down(0, -1, 0);
  StrokeRegion region;
  region.add(SweptCylinder({Vec3(0, 0.5, 0), down}, {Vec3(1, -0.5, 0), down}, 0.1, {0, 10}));
  region.record_near(FaceId(0), 0);
  const auto small = [](double x) { return Triangle{Vec3(x, 0, 0), Vec3(x + 0.05, 0, 0), Vec3(x, 0, 0.05)}; };
  EXPECT_TRUE(region.reaches_into(FaceId(0), small(0.3), 0.01));
  EXPECT_FALSE(region.reaches_into(FaceId(0), small(0.8), 0.01));
}

// A part whose beam turns is asked at points of a small triangle.
TEST(StrokeRegion, reaches_into_small_triangles_with_points_in_a_tilting_beam) {
  Random random(9);
  const auto any = [&](double most) { return random.uniform(-most, most); };
  size_t within = 0, beyond = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 from = glm::normalize(Vec3(any(0.3), -1, any(0.3))),
               to = glm::normalize(Vec3(any(0.3), -1, any(0.3)));
    StrokeRegion region;
    region.add(SweptCylinder({Vec3(0, 5, 0), from}, {Vec3(0.5, 5, 0), to}, 0.5, {0, 10}));
    region.record_near(FaceId(0), 0);
    const Vec3 at(any(2), any(1), any(2));
    const Triangle t{at, at + Vec3(any(0.1), any(0.1), any(0.1)), at + Vec3(any(0.1), any(0.1), any(0.1))};
    const double distance = region.part(0).signed_distance((t[0] + t[1] + t[2]) / 3.0);
    if (distance < -0.25) {
      EXPECT_TRUE(region.reaches_into(FaceId(0), t, 0.05)) << i;
      ++within;
    } else if (distance > 0.25) {
      EXPECT_FALSE(region.reaches_into(FaceId(0), t, 0.05)) << i;
      ++beyond;
    }
  }
  EXPECT_GT(within, 10u);
  EXPECT_GT(beyond, 50u);
}

TEST_F(RegionAlongX, crosses_segments_at_zero_distance) {
  note(FaceId(0), {0, 1, 2, 3});
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const Vec3 inside(random.uniform(0, 4), 0, random.uniform(-0.4, 0.4));
    const Vec3 outside(random.uniform(0, 4), 0, random.uniform(0.6, 3));
    const Vec3 at = region_.crossing(FaceId(0), inside, outside);
    EXPECT_NEAR(region_.signed_distance(FaceId(0), at), 0, 1e-6);
    EXPECT_NEAR(glm::length(glm::cross(at - inside, outside - inside)), 0, 1e-9) << "on the segment";
  }
}

// A beam through the left corners of a triangle, and one across its sides to the right corner.
TEST(ChordFails, if_an_edge_enters_the_region_again) {
  const Vec3 down(0, -1, 0);
  const Triangle t{Vec3(0), Vec3(0.9, 0, 0), Vec3(0, 0, 0.01)};
  for (const bool again : {true, false}) {
    SCOPED_TRACE(again);
    StrokeRegion region;
    for (uint32_t part = 0; part < (again ? 2u : 1u); ++part) {
      const Pose still{Vec3(0.6 * part, 5, 0), down};
      region.add(SweptCylinder(still, still, 0.05, {0, 10}));
      region.record_near(FaceId(0), part);
    }
    std::array<double, 3> distances{};
    for (size_t i = 0; i < 3; ++i) distances[i] = region.signed_distance(FaceId(0), t[i]);
    EXPECT_EQ(chord_fails(region, FaceId(0), t, distances, 1e-3, 1e-4), again);
  }
}

}  // namespace
}  // namespace kerf
