#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/ids.h"
#include "core/base/random.h"
#include "core/edit/body_edit.h"
#include "core/edit/separation.h"
#include "core/physics/physics.h"
#include "core/physics/sleep.h"
#include "tests/support/made_meshes.h"
#include "tests/support/piles.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

using test::let_move;
using test::world_with_ground;

bool all_sleep(const World& world) {
  for (BodyId id : world.ids()) {
    if (!world.body(id).pinned && !world.body(id).motion.asleep) return false;
  }
  return true;
}

double height(const World& world, BodyId id) { return world.body(id).placement.position.y; }

TEST(Fall, a_plate_falls_to_the_ground_and_sleeps_there) {
  World world = world_with_ground();
  const BodyId plate = test::add(world, test::rectangle(0.5, 0.3, 4), {0, 1, 0});
  let_move(world, 0.25);
  EXPECT_NEAR(height(world, plate), 1 - 0.5 * 9.81 * 0.25 * 0.25, 0.03);
  let_move(world, 3);
  EXPECT_TRUE(all_sleep(world));
  EXPECT_NEAR(height(world, plate), 0.001, 0.0005);
}

TEST(Contacts, of_a_removed_body_are_cleared) {
  World world = world_with_ground();
  const BodyId table = test::add(world, test::rectangle(1, 1, 1), {0, 1, 0});
  world.body(table).pinned = true;
  const BodyId plate = test::add(world, test::rectangle(0.5, 0.3, 4), {0, 1.003, 0});
  const auto known = [&] {
    return std::ranges::count_if(world.contact_memory(),
                                 [&](const PairMemory& m) { return m.first == table && m.second == plate; });
  };
  Physics physics;
  for (int i = 0; i < 10; ++i) physics.tick(world);
  EXPECT_EQ(known(), 1);
  world.body(plate).placement.position.y = 9;
  world.body(plate).motion.wake();
  physics.tick(world);
  EXPECT_EQ(known(), 0);
}

TEST(Contacts, keep_no_details_of_a_collider_older_than_the_faces) {
  World world = world_with_ground();
  const BodyId table = test::add(world, test::rectangle(1, 1, 101), {0, 1, 0});
  ASSERT_GT(world.body(table).mesh.live_faces(), Physics::kMaxUnderBeam);
  world.body(table).pinned = true;
  const BodyId plate = test::add(world, test::rectangle(0.5, 0.3, 4), {0, 1.003, 0});
  const auto known = [&]() -> const PairMemory& {
    const auto at = std::ranges::find_if(
        world.contact_memory(), [&](const PairMemory& m) { return m.first == table && m.second == plate; });
    EXPECT_NE(at, world.contact_memory().end());
    return *at;
  };
  Physics physics;
  for (int i = 0; i < 10; ++i) physics.tick(world);
  const std::vector<FaceId> corner{FaceId(0)};
  BodyEdit(world.body(table)).remove(corner);
  settle(world.body(table));
  Delta cut;
  cut.bodies.push_back({table, {}, corner, {}, {}, {}});
  physics.follow(cut);
  forget_contacts(world, cut);
  for (int i = 0; i < 3; ++i) physics.tick(world, true);
  ASSERT_TRUE(physics.needs_collider(world, table, false));
  EXPECT_TRUE(known().touching);
  EXPECT_TRUE(known().points_of_first.empty() && known().points_of_second.empty());
  EXPECT_TRUE(known().impulses.empty());
  for (int i = 0; i < 3; ++i) physics.tick(world);
  EXPECT_FALSE(physics.needs_collider(world, table, false));
  EXPECT_FALSE(known().impulses.empty());
}

TEST(Tick, reports_unpinned_awake_bodies_as_moved) {
  World world = world_with_ground();
  const BodyId table = test::add(world, test::rectangle(1, 1, 1), {0, 1, 0});
  world.body(table).pinned = true;
  const BodyId asleep = test::add(world, test::rectangle(0.5, 0.3, 4), {6, 0.1, 0});
  let_move(world, 3);
  ASSERT_TRUE(all_sleep(world));
  const Vec3 resting = world.body(asleep).placement.position;
  const BodyId falling = test::add(world, test::rectangle(0.5, 0.3, 4), {3, 1, 0});
  Physics physics;
  const Delta delta = physics.tick(world);
  EXPECT_EQ(delta.moved, std::vector{falling});
  EXPECT_EQ(physics.statistics().awake, 1u);
  EXPECT_EQ(world.body(table).placement.position, Vec3(0, 1, 0));
  EXPECT_EQ(world.body(asleep).placement.position, resting);
}

TEST(Tick, ignores_a_body_without_faces) {
  World world = world_with_ground();
  test::add(world, test::rectangle(0.5, 0.3, 4), {0, 1, 0});
  const BodyId empty = test::add(world, test::rectangle(0.5, 0.3, 1), {0, 1.1, 0});
  const std::vector<FaceId> faces = world.body(empty).faces_of(0);
  BodyEdit(world.body(empty)).remove(faces);
  Physics physics;
  physics.tick(world);
  EXPECT_EQ(physics.statistics().bodies, 1u);
  EXPECT_EQ(world.body(empty).placement.position, Vec3(0, 1.1, 0));
}

// Returns true if a plate with a diagonal of this length [m] turns after a tick that it began with this spin.
bool still_turns(double diagonal, double spin, bool touched) {
  World world;
  const BodyId id = test::add(world, test::rectangle(0.6 * diagonal, 0.8 * diagonal, 2), Vec3(0));
  world.body(id).motion.spin = {0, spin, 0};
  PairMemory on_ground{id, BodyId{}, {}, {}, {}};
  on_ground.touching = touched;
  world.set_contact_memory({on_ground});
  Physics physics;
  physics.tick(world);
  return world.body(id).motion.spin != Vec3(0);
}

// The spin [rad/s] decreases by 0.7 times gravity over the diagonal in a second.
TEST(Tick, brakes_the_spin_of_a_body_that_touched) {
  for (const double diagonal : {1.0, 0.5}) {
    SCOPED_TRACE(diagonal);
    const double lost = 0.7 * 9.81 / diagonal * kTick;
    EXPECT_FALSE(still_turns(diagonal, 0.97 * lost, true));
    EXPECT_TRUE(still_turns(diagonal, 1.03 * lost, true));
    EXPECT_TRUE(still_turns(diagonal, 0.97 * lost, false));
  }
}

// Many more vertices than the points by which bodies touch each other.
TEST(Fall, a_curved_body_rests_on_its_lowest_vertices) {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world = world_with_ground();
    const glm::dquat turn(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 1);
    const BodyId ring = test::add(world, test::torus(48, 24, 1, 0.6), {0, 2, 0}, glm::normalize(turn));
    let_move(world, 6);
    EXPECT_TRUE(all_sleep(world));
    const Body& body = world.body(ring);
    double lowest = 1;
    for (uint32_t v = 0; v < body.mesh.vertex_slots(); ++v)
      lowest = std::min(lowest, body.placement.to_world(body.mesh.position(VertexId(v))).y);
    EXPECT_NEAR(lowest, 0.001, 0.001);
  }
}

std::vector<BodyId> add_stack(World& world, int count) {
  std::vector<BodyId> plates;
  for (int i = 0; i < count; ++i) {
    plates.push_back(test::add(world, test::rectangle(0.8, 0.8, 3), {0.002 * i, 0.05 * (i + 1), 0}));
  }
  return plates;
}

TEST(Fall, ten_plates_come_to_rest_in_their_order_within_a_second) {
  World world = world_with_ground();
  const std::vector<BodyId> plates = add_stack(world, 10);
  let_move(world, 1);
  EXPECT_TRUE(all_sleep(world));
  for (size_t i = 0; i + 1 < plates.size(); ++i) {
    EXPECT_NEAR(height(world, plates[i + 1]) - height(world, plates[i]), 0.002, 0.0005) << i;
  }
}

double energy(const World& world) {
  double joules = 0;
  for (BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const RigidFrame frame = rigid_frame(body);
    const Placement p = frame.in_world(body.placement);
    const Vec3 velocity = body.motion.velocity_at(p.position, body.placement);
    const Vec3 spin = glm::conjugate(p.orientation) * body.motion.spin;
    joules += frame.mass * (9.81 * p.position.y + 0.5 * glm::dot(velocity, velocity)) +
              0.5 * glm::dot(spin * frame.inertia, spin);
  }
  return joules;
}

TEST(Fall, a_stack_gains_no_energy) {
  World world = world_with_ground();
  add_stack(world, 10);
  Physics physics;
  const double at_first = energy(world);
  double gained = 0, before = at_first;
  for (Ticks t = 0; t < 2 * kTicksPerSecond; ++t) {
    physics.tick(world);
    const double now = energy(world);
    gained += std::max(now - before, 0.0);
    before = now;
  }
  EXPECT_LT(gained, 0.01 * at_first);
}

TEST(Fall, continues_bit_for_bit_when_caches_are_rebuilt_at_any_tick) {
  Random random(7);
  World whole = world_with_ground(), torn = world_with_ground();
  for (World* world : {&whole, &torn}) {
    add_stack(*world, 4);
    test::add(*world, test::rod(0.01, 0.4, 8), {0.1, 0.6, 0.05},
              glm::normalize(glm::dquat(1, 0.7, 0.1, 0.2)));
  }
  Physics physics;
  auto renewed = std::make_unique<Physics>();
  for (Ticks t = 0; t < kTicksPerSecond; ++t) {
    physics.tick(whole);
    if (random.below(4) == 0) renewed = std::make_unique<Physics>();
    renewed->tick(torn);
    for (BodyId id : whole.ids()) {
      ASSERT_EQ(whole.body(id).placement, torn.body(id).placement) << t;
      ASSERT_EQ(whole.body(id).motion, torn.body(id).motion) << t;
    }
  }
}

TEST(Fall, halves_across_a_kerf_do_not_push_each_other) {
  World world = world_with_ground();
  const BodyId left = test::add(world, test::rectangle(1, 1, 5), {-0.502, 0.3, 0});
  const BodyId right = test::add(world, test::rectangle(1, 1, 5), {0.502, 0.3, 0});
  for (BodyId id : {left, right})
    test::add(world, test::closed_box({0.8, 0.2, 0.8}), world.body(id).placement.position - Vec3(0, 0.15, 0));
  let_move(world, 1.5);
  EXPECT_NEAR(world.body(right).placement.position.x - world.body(left).placement.position.x, 1.004, 0.0002);
}

TEST(Fall, a_rod_falls_through_a_wide_hole_and_is_held_by_a_narrow_one) {
  for (const double hole : {0.0075, 0.004}) {
    World world = world_with_ground();
    const BodyId plate = test::add(world, test::plate_with_hole(0.3, hole / 2, 24), {0, 0.5, 0});
    world.body(plate).pinned = true;
    const BodyId rod = test::add(world, test::rod(0.0025, 0.2, 12), {0, 0.62, 0});
    let_move(world, 0.4);
    EXPECT_EQ(height(world, rod) < 0.45, hole > 0.005) << hole << " " << height(world, rod);
  }
}

TEST(Fall, a_disc_falls_through_its_own_hole) {
  World world = world_with_ground();
  const BodyId plate = test::add(world, test::plate_with_hole(0.5, 0.075, 48), {0, 0.5, 0});
  world.body(plate).pinned = true;
  const BodyId disc = test::add(world, test::disc(0.0735, 48), {0, 0.5, 0});
  let_move(world, 0.3);
  EXPECT_LT(height(world, disc), 0.3);
}

TEST(Fall, nothing_passes_a_pinned_sheet_at_any_speed) {
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    for (const double speed : {30.0, 80.0}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " at " + std::to_string(speed) + " m/s");
      Random random(seed);
      World world = world_with_ground();
      const BodyId sheet = test::add(world, test::rectangle(6, 6, 6), {0, 1, 0});
      world.body(sheet).pinned = true;
      const glm::dquat turn = glm::normalize(glm::dquat(random.uniform(-1, 1), random.uniform(-1, 1),
                                                        random.uniform(-1, 1), random.uniform(-1, 1)));
      const BodyId fast =
          test::add(world, test::rectangle(0.3, 0.2, 3), {random.uniform(-0.5, 0.5), 2, 0}, turn);
      world.body(fast).motion.velocity = {0, -speed, 0};
      world.body(fast).motion.spin = {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
      Physics physics;
      for (int t = 0; t < 36; ++t) {
        physics.tick(world);
        ASSERT_GT(height(world, fast), 1) << t;
      }
    }
  }
}

// Four plates, one over the other, that fall, slide and come to rest; in a unit of 1/1024 m they do it alike,
// as a power of two changes no digit.
TEST(Fall, a_world_in_another_unit_behaves_like_one_in_metres) {
  const auto made = [](double metre) {
    World world;
    world.set_environment({.gravity = {0, -9.81 * metre, 0}, .ground = 0, .metre = metre});
    for (int i = 0; i < 4; ++i) {
      const glm::dquat tilted = glm::normalize(glm::dquat(1, 0.1 * i, 0.05, -0.08 * i));
      test::add(world, test::rectangle(0.1 * metre, 0.07 * metre, 2),
                metre * Vec3(0.02 * i, 0.2 + 0.06 * i, 0.01 * i), tilted);
    }
    return world;
  };
  constexpr double kMetre = 1024;
  World metres = made(1), units = made(kMetre);
  Physics in_metres, in_units;
  const std::vector<BodyId> ids = metres.ids();
  for (int t = 0; t < 5 * static_cast<int>(kTicksPerSecond) && !all_sleep(metres); ++t) {
    in_metres.tick(metres);
    in_units.tick(units);
    for (const BodyId id : ids) {
      const Body &a = metres.body(id), &b = units.body(id);
      const double apart = glm::length(kMetre * a.placement.position - b.placement.position);
      ASSERT_LT(apart, 1e-6 * kMetre) << "tick " << t;
      ASSERT_EQ(a.motion.asleep, b.motion.asleep) << "tick " << t;
    }
  }
  EXPECT_TRUE(all_sleep(units));
}

}  // namespace
}  // namespace kerf
