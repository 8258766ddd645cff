#include "core/physics/contact/penetration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/ids.h"
#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// The edge of a plate that falls across a narrow bar: its corners pass the bar by.
class PlateAcrossBar : public testing::Test {
 protected:
  PlateAcrossBar() {
    sheets_.add(test::rectangle(1, 1, 1), {0, 0.05, 0});
    sheets_.add(test::rectangle(0.1, 4, 1), Vec3(0));
    sheets_.body(0).motion.velocity = {0, -0.05 / kTick, 0};
  }

  test::MovingSheets sheets_;
  std::vector<PointMemory> memory_;
};

TEST_F(PlateAcrossBar, adds_points_on_chords_that_pierce_it) {
  sheets_.body(1).placement.orientation = glm::angleAxis(0.3, Vec3(0, 0, 1));
  const std::vector<MovingBody>& bodies = sheets_.bodies();
  remember_piercing_points(bodies[0], bodies[1], memory_);
  ASSERT_FALSE(memory_.empty());
  for (const PointMemory& m : memory_) {
    EXPECT_TRUE(is_on_chord(m.point));
    const Collider::Chord& chord = chord_of(*bodies[0].collider, m.point);
    const Vec3 at = point_of(*bodies[0].collider, m.point).at, way = chord.to - chord.from;
    EXPECT_LT(glm::length(glm::cross(at - chord.from, way)), 1e-9) << "the point lies on its chord";
    EXPECT_NEAR(glm::length(m.normal), 1, 1e-9);
  }
}

TEST_F(PlateAcrossBar, adds_none_without_intersection) {
  sheets_.body(0).motion.velocity = {0, -0.01 / kTick, 0};
  const std::vector<MovingBody>& bodies = sheets_.bodies();
  EXPECT_FALSE(remember_piercing_points(bodies[0], bodies[1], memory_));
  EXPECT_TRUE(memory_.empty());
}

TEST_F(PlateAcrossBar, stores_each_place_once_in_order) {
  sheets_.body(1).placement.orientation = glm::angleAxis(0.3, Vec3(0, 0, 1));
  const std::vector<MovingBody>& bodies = sheets_.bodies();
  remember_piercing_points(bodies[0], bodies[1], memory_);
  const size_t once = memory_.size();
  EXPECT_FALSE(remember_piercing_points(bodies[0], bodies[1], memory_));
  EXPECT_EQ(memory_.size(), once);
  EXPECT_TRUE(std::is_sorted(memory_.begin(), memory_.end(),
                             [](const PointMemory& a, const PointMemory& b) { return a.point < b.point; }));
}

TEST(ChordPoints, at_an_oblique_rim_separate_in_the_plane_of_the_face) {
  test::MovingSheets sheets;
  sheets.add(test::rectangle(0.4, 0.4, 1), {0.03, 0.01, 0.3});  // its edges along x fall across a rim along z
  const glm::dquat standing(std::sqrt(0.5), 0, 0, std::sqrt(0.5));  // in x = 0
  sheets.add(test::rectangle(0.4, 2, 1), {0, -0.2, 0}, standing);
  sheets.body(0).motion.velocity = Vec3(0.01, -0.02, 0) / kTick;
  const std::vector<MovingBody>& bodies = sheets.bodies();
  std::vector<PointMemory> memory;
  EXPECT_TRUE(remember_piercing_points(bodies[0], bodies[1], memory));
  ASSERT_FALSE(memory.empty());
  for (const PointMemory& m : memory) {
    EXPECT_TRUE(is_at_rim(m.point));
    EXPECT_LT(glm::length(bodies[1].now.turn * m.normal - Vec3(0, 1, 0)), 1e-9);
  }
}

// A plate falls onto the rim of a standing one, which two of its edges cross at this share of their length.
TEST(ChordPoints, at_a_rim_lie_where_their_chord_passes_it) {
  constexpr double kWidth = 0.4, kPlaces = 4096;  // along a chord
  for (const double share : {0.0001, 0.3, 0.9999}) {
    SCOPED_TRACE(share);
    test::MovingSheets sheets;
    sheets.add(test::rectangle(kWidth, 0.4, 1), {kWidth * (0.5 - share), 0.01, 0.3});
    const glm::dquat standing(std::sqrt(0.5), 0, 0, std::sqrt(0.5));  // in x = 0
    sheets.add(test::rectangle(0.4, 2, 1), {0, -0.2, 0}, standing);
    sheets.body(0).motion.velocity = Vec3(0, -0.02, 0) / kTick;
    const std::vector<MovingBody>& bodies = sheets.bodies();
    std::vector<PointMemory> memory;
    EXPECT_TRUE(remember_piercing_points(bodies[0], bodies[1], memory));
    EXPECT_EQ(memory.size(), 2u);
    for (const PointMemory& m : memory) {
      ASSERT_TRUE(is_at_rim(m.point));
      EXPECT_NEAR(bodies[0].next(point_of(*bodies[0].collider, m.point).at).x, 0, 1.001 * kWidth / kPlaces);
    }
  }
}

TEST(ChordPoints, have_distinct_ids_from_collider_points) {
  EXPECT_FALSE(is_on_chord(5));
  EXPECT_TRUE(is_on_chord(kOnChord | 5));
  EXPECT_FALSE(is_at_rim(kOnChord | 5));
  EXPECT_TRUE(is_at_rim(kOnChord | kAtRim | 5));
  EXPECT_FALSE(is_at_rim(kAtRim | 5));
}

}  // namespace
}  // namespace kerf
