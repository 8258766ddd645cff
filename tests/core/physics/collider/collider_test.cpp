#include "core/physics/collider/collider.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/physics/collider/simplify_line.h"
#include "core/physics/contact/rigid_frame.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"

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

TEST(Collider, points_of_a_rim_know_where_the_sheet_ends) {
  for (const Collider::Point& p : make_collider(test::build(test::disc(1, 32)).mesh).points) {
    if (glm::length(p.at) > 0.5) EXPECT_GT(glm::dot(p.outward, p.at), 0.9);
  }
}

TEST(Collider, has_no_more_than_is_asked_for) {
  const ColliderSettings few{.most_points = 10, .most_chords = 12, .chord_error = 1e-9};
  const Collider collider = make_collider(test::build(test::tube(5, 200, 1, 1)).mesh, few);
  EXPECT_LE(collider.points.size(), 10u);
  EXPECT_LE(collider.chords.size(), 12u);
}

TEST(SimplifiedLine, stays_within_its_error) {
  std::vector<Vec3> line;
  for (int i = 0; i <= 200; ++i) line.emplace_back(0.01 * i, std::sin(0.05 * i), 0);
  const std::vector<Vec3> few = simplified(line, 0.01);
  EXPECT_LT(few.size(), 40u);
  for (const Vec3& p : line) {
    double nearest = 1;
    for (size_t i = 0; i + 1 < few.size(); ++i) {
      const Vec3 way = few[i + 1] - few[i];
      const double t = std::clamp(glm::dot(p - few[i], way) / glm::dot(way, way), 0.0, 1.0);
      nearest = std::min(nearest, glm::length(p - few[i] - t * way));
    }
    EXPECT_LE(nearest, 0.01);
  }
}

TEST(SimplifiedLine, of_every_error_follows_from_those_of_the_least) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    std::vector<Vec3> line(2 + random.below(60));
    for (Vec3& p : line) p = {random.unit(), random.unit(), random.unit()};
    if (seed % 2 == 0) line.back() = line.front();
    const std::vector<double> from = left_out_from(line, 0.01);
    for (const double error : {0.01, 0.05, 0.2, 0.4, 2.0}) {
      std::vector<Vec3> kept;
      for (size_t i = 0; i < line.size(); ++i) {
        if (from[i] > error * error) kept.push_back(line[i]);
      }
      EXPECT_EQ(kept, simplified(line, error)) << "seed " << seed << ", error " << error;
    }
  }
}

// Closed forms of thin shells of surface density s: a plate a x b, a tube of radius r and length l.
TEST(RigidFrame, has_the_mass_and_inertia_of_closed_forms) {
  World world;
  const BodyId plate = test::add(world, test::rectangle(0.6, 0.4, 3), {5, 6, 7});
  RigidFrame frame = rigid_frame(world.body(plate));
  const double m = 0.6 * 0.4 * 0.001 * 7850;
  EXPECT_NEAR(frame.mass, m, 1e-12);
  std::array<double, 3> inertia{frame.inertia.x, frame.inertia.y, frame.inertia.z};
  std::sort(inertia.begin(), inertia.end());
  EXPECT_NEAR(inertia[0], m * 0.16 / 12, 1e-12);
  EXPECT_NEAR(inertia[1], m * 0.36 / 12, 1e-12);
  EXPECT_NEAR(inertia[2], m * 0.52 / 12, 1e-12);
}

TEST(RigidFrame, gives_back_the_placement_it_was_put_in) {
  World world;
  const Soup soup = test::moved(test::rectangle(0.6, 0.4, 3), {3, -2, 8}, 1);
  const BodyId id = test::add(world, soup, {5, 6, 7}, glm::normalize(glm::dquat(1, 2, -1, 0.5)));
  const Body& body = world.body(id);
  const RigidFrame frame = rigid_frame(body);
  const Placement back = frame.body_at(frame.in_world(body.placement));
  EXPECT_LT(glm::length(back.position - body.placement.position), 1e-13);
  EXPECT_LT(glm::length(frame.in_world(body.placement).position - body.placement.to_world({3, -2, 8})),
            1e-12);
}

}  // namespace
}  // namespace kerf
