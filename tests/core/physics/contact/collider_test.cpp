#include "core/physics/contact/collider.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

TEST(Collider, of_a_plate_has_its_corners_and_four_chords_around_it) {
  const Collider collider = make_collider(test::build(test::rectangle(2, 1, 8)).mesh);
  EXPECT_EQ(collider.chords.size(), 4u);
  EXPECT_EQ(collider.points.size(), 81u);  // all vertices
  for (const Vec3 corner : {Vec3(-1, 0, -0.5), Vec3(1, 0, -0.5), Vec3(-1, 0, 0.5), Vec3(1, 0, 0.5)}) {
    EXPECT_TRUE(std::any_of(collider.points.begin(), collider.points.end(),
                            [&](const Collider::Point& p) { return glm::length(p.at - corner) < 1e-12; }));
  }
}

TEST(Collider, of_a_box_has_its_twelve_creases) {
  EXPECT_EQ(make_collider(test::build(test::closed_box({1, 2, 3})).mesh).chords.size(), 12u);
}

TEST(Collider, of_a_closed_smooth_mesh_has_no_chord) {
  EXPECT_TRUE(make_collider(test::build(test::sphere(24, 48, 1)).mesh).chords.empty());
}

TEST(Collider, rim_points_store_the_outward_direction) {
  for (const Collider::Point& p : make_collider(test::build(test::disc(1, 32)).mesh).points) {
    if (glm::length(p.at) > 0.5) EXPECT_GT(glm::dot(p.outward, p.at), 0.9);
  }
}

TEST(Collider, stays_within_its_limits) {
  const ColliderSettings few{.max_points = 10, .max_chords = 12, .chord_error = 1e-9};
  const Collider collider = make_collider(test::build(test::tube(5, 200, 1, 1)).mesh, few);
  EXPECT_LE(collider.points.size(), 10u);
  EXPECT_LE(collider.chords.size(), 12u);
}

// Each vertex of the rim lies 0.019 m off the line between its neighbours.
TEST(Collider, keeps_its_error_if_exactly_the_allowed_chords_suffice) {
  const Mesh mesh = test::build(test::disc(1, 32)).mesh;
  EXPECT_EQ(make_collider(mesh, {.max_chords = 32, .chord_error = 0.01}).chords.size(), 32u);
  EXPECT_EQ(make_collider(mesh, {.max_chords = 31, .chord_error = 0.01}).chords.size(), 16u);
}

}  // namespace
}  // namespace kerf
