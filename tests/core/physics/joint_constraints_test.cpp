#include "core/physics/solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/ids.h"
#include "core/base/random.h"
#include "core/document/document.h"
#include "core/joints/joined_parts.h"
#include "core/physics/physics.h"
#include "core/world/world.h"
#include "tests/core/physics/moving_sheets.h"
#include "tests/support/jointed.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"

namespace kerf {
namespace {

using test::NamedSheet;

constexpr double kPi = std::numbers::pi;
const glm::dquat kUpright(std::sqrt(0.5), std::sqrt(0.5), 0, 0);  // turns y = 0 to z = 0

// A frame and a door below it, hinged along x at y = 0. The door reaches down by `height`.
World door_world(double height, std::optional<Interval> limits) {
  const std::vector<NamedSheet> sheets{
      {"frame", test::rectangle(2, 0.6, 4), {0, 0.31, 0}, kUpright},
      {"door", test::rectangle(0.8, height, 4), {0, -0.01 - 0.5 * height, 0}, kUpright}};
  JointDescription hinge;
  hinge.kind = Joint::Kind::kHinge;
  hinge.parts = {"door", "frame"};
  hinge.axis = {1, 0, 0};
  hinge.limits = limits;
  World world = test::jointed_world(sheets, {&hinge, 1});
  const std::vector<BodyId> bodies = test::part_bodies(world);
  EXPECT_EQ(bodies.size(), 2u);
  world.body(bodies[0]).pinned = true;
  return world;
}

// The body that is not pinned.
Body& door_of(World& world) { return world.body(world.ids()[1]); }

// Turns a body about the x axis of the world.
void turn(Body& body, double angle) {
  body.placement.orientation = glm::angleAxis(angle, Vec3(1, 0, 0)) * body.placement.orientation;
}

// By how much a body is turned about the x axis.
double angle_of(const Body& body) {
  const Vec3 down = body.placement.orientation * Vec3(0, -1, 0);
  return std::atan2(-down.z, -down.y);
}

TEST(Joints, a_door_swings_on_its_hinge_with_the_period_of_a_pendulum) {
  constexpr double kHeight = 0.6, kStart = 0.1;
  World world = door_world(kHeight, std::nullopt);
  Body& door = door_of(world);
  turn(door, kStart);
  Physics physics;
  double crossed_first = 0, crossed_last = 0, before = angle_of(door);
  int crossings = 0;
  for (int t = 1; t <= 6 * static_cast<int>(kTicksPerSecond); ++t) {
    physics.tick(world);
    const double angle = angle_of(door);
    EXPECT_LT(glm::length(door.placement.to_world({0, 0, 0})), 0.001) << "tick " << t;
    EXPECT_LT(std::abs((door.placement.orientation * Vec3(1, 0, 0)).y), 0.001);
    if (before > 0 && angle <= 0) {
      const double when = kTick * (t - angle / (angle - before));
      (crossings++ == 0 ? crossed_first : crossed_last) = when;
    }
    before = angle;
    if (door.motion.asleep) break;
  }
  ASSERT_GE(crossings, 2);
  // A plate that hangs with a gap of 1 cm: inertia about the axis over mass times g times arm.
  const double arm = 0.01 + 0.5 * kHeight, inertia = kHeight * kHeight / 12 + arm * arm;
  const double period = 2 * kPi * std::sqrt(inertia / (9.81 * arm));
  EXPECT_NEAR((crossed_last - crossed_first) / (crossings - 1), period, 0.02 * period);
}

TEST(Joints, a_door_stops_at_its_hinge_limits_without_bouncing) {
  World world = door_world(0.5, Interval{-25, 15});
  Body& door = door_of(world);
  Physics physics;
  for (const double sign : {1.0, -1.0}) {
    Environment around = world.environment();
    around.gravity = {0, -3, -sign * 9};
    world.set_environment(around);
    door.motion = {};
    const double limit = sign > 0 ? 15 : -25;
    bool reached = false;
    for (int t = 0; t < 240; ++t) {
      physics.tick(world);
      const double off = std::abs(180 / kPi * angle_of(door) - limit);
      reached = reached || off < 0.5;
      if (reached) EXPECT_LT(off, 2.5) << "tick " << t;
    }
    EXPECT_NEAR(180 / kPi * angle_of(door), limit, 1);
  }
}

TEST(Joints, a_weld_keeps_two_falling_bodies_together) {
  World world;
  {
    const std::vector<NamedSheet> sheets{{"plate", test::rectangle(0.5, 0.5, 4)},
                                         {"flag", test::rectangle(0.2, 0.2, 2), {0, 0.12, 0}, kUpright}};
    JointDescription hinge;
    hinge.kind = Joint::Kind::kHinge;
    hinge.parts = {"flag", "plate"};
    world = test::jointed_world(sheets, {&hinge, 1});
    const auto bodies = test::part_bodies(world);
    ASSERT_EQ(bodies.size(), 2u);
    Joints joints = world.joints();
    joints.all[0].kind = Joint::Kind::kWeld;
    world.set_joints(joints);
  }
  const std::vector<BodyId> bodies = world.ids();
  Body &plate = world.body(bodies[0]), &flag = world.body(bodies[1]);
  plate.motion.spin = {1, 2, 3};
  world.set_environment({.gravity = {0, -9.81, 0}, .ground = -1});
  Physics physics;
  for (int t = 0; t < 240; ++t) {
    physics.tick(world);
    const Vec3 anchor = world.joints().all[0].anchor;
    ASSERT_LT(glm::length(plate.placement.to_world(anchor) - flag.placement.to_world(anchor)), 0.003) << t;
    const double aligned = std::abs(glm::dot(plate.placement.orientation, flag.placement.orientation));
    ASSERT_GT(aligned, 0.9995) << t;
  }
}

// A cart on four wheels of 48 sides, whose hubs lie along x.
World cart() {
  std::vector<NamedSheet> sheets{{"cart", test::closed_box({0.6, 0.2, 1.2}), {0, 0.35, 0}}};
  std::vector<JointDescription> hubs;
  const glm::dquat along_x(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  for (int i = 0; i < 4; ++i) {
    const Vec3 at(i & 1 ? 0.4 : -0.4, 0.201, i & 2 ? 0.4 : -0.4);
    sheets.push_back({"wheel" + std::to_string(i), test::rod(0.2, 0.1, 48), at, along_x});
    JointDescription hub;
    hub.kind = Joint::Kind::kHub;
    hub.parts = {sheets.back().name, "cart"};
    hub.anchor = at;
    hub.axis = {1, 0, 0};
    hubs.push_back(hub);
  }
  World world = test::jointed_world(sheets, hubs);
  EXPECT_EQ(test::part_bodies(world).size(), 5u);
  return world;
}

TEST(Joints, jointed_parts_are_not_pushed_apart) {
  const World world = cart();
  for (const BodyId id : world.ids()) EXPECT_TRUE(world.body(id).motion.at_rest());
}

TEST(Joints, wheels_roll_on_their_hubs) {
  World world = cart();
  constexpr double kRadius = 0.2, kSpeed = 3, kSeconds = 1.5;
  world.set_environment({.gravity = {0, -9.81, 0}, .ground = 0});
  const std::vector<BodyId> bodies = world.ids();
  for (const BodyId id : bodies) world.body(id).motion.velocity = {0, 0, kSpeed};
  Physics physics;
  for (double t = 0; t < kSeconds; t += kTick) physics.tick(world);
  const double speed = world.body(bodies[0]).motion.velocity.z;
  EXPECT_GT(speed, 0.5);
  // Sliding, it would have stopped after speed^2 / (2 * friction * g).
  EXPECT_GT(world.body(bodies[0]).placement.position.z, 2.5 * kSpeed * kSpeed / (2 * 0.6 * 9.81));
  for (size_t i = 1; i < bodies.size(); ++i) {
    EXPECT_NEAR(world.body(bodies[i]).motion.spin.x, speed / kRadius, 0.08 * speed / kRadius) << i;
  }
}

TEST(Joints, a_part_moved_away_by_hand_is_released) {
  for (const double way : {0.01, 2.0}) {
    World world = cart();
    world.set_environment({.gravity = {0, -9.81, 0}, .ground = 0});
    const BodyId wheel = world.ids()[1];
    world.body(wheel).placement.position.x += way;
    const Vec3 anchor = world.joints().all[0].anchor;
    Physics physics;
    for (int t = 0; t < 60; ++t) physics.tick(world);
    const auto place = [&](BodyId id) { return world.body(id).placement.to_world(anchor); };
    const double apart = glm::length(place(wheel) - place(world.ids()[0]));
    if (way < 1) EXPECT_LT(apart, 0.003);
    if (way > 1) EXPECT_GT(apart, 0.9 * way);
  }
}

// Walks time in which bodies move.
void play(Document& document, double seconds) {
  document.apply(AdvanceTime{static_cast<Ticks>(seconds * static_cast<double>(kTicksPerSecond)), true});
  ASSERT_TRUE(test::run_all(document).ok());
}

// A pinned frame with a door on two hinges at its lower edge; each is carried by the faces around it.
Document door_on_two_hinges() {
  const std::vector<NamedSheet> sheets{{"frame", test::rectangle(2, 0.6, 20), {0, 0.31, 0}, kUpright},
                                       {"door", test::rectangle(0.8, 0.5, 10), {0, -0.26, 0}, kUpright}};
  std::vector<JointDescription> hinges(2);
  for (size_t i = 0; i < 2; ++i) {
    hinges[i].kind = Joint::Kind::kHinge;
    hinges[i].parts = {"door", "frame"};
    hinges[i].anchor = {i == 0 ? -0.3 : 0.3, 0, 0};
    hinges[i].axis = {1, 0, 0};
    hinges[i].radius = 0.06;
  }
  Document document(test::jointed_world(sheets, hinges));
  document.apply(Play{});
  play(document, 1.0 / 60);
  const World& world = document.world();
  EXPECT_EQ(world.ids().size(), 2u);
  EXPECT_TRUE(document.apply(Command(PinPiece{{world.ids()[0], 0}, true})).ok());
  return document;
}

// Burns the faces of the door away that carry the hinge at x.
void burn_hinge(Document& document, double x) {
  CutSettings settings;
  settings.laser.radius = 0.1;
  settings.laser.range = {0, 3};
  settings.resolution.target_edge = 0.02;
  document.apply(BeginStroke{settings, {{x, -0.05, 1}, {0, 0, -1}}});
  document.apply(MoveBeam{{{x, -0.06, 1}, {0, 0, -1}}});
  document.apply(EndStroke{});
  ASSERT_TRUE(test::run_all(document).ok());
}

TEST(Joints, a_door_swings_on_its_last_hinge_and_drops_without_it) {
  Document document = door_on_two_hinges();
  const auto depth = [&] {
    const Body& door = document.world().body(document.world().ids()[1]);
    return -door.placement.to_world(rigid_frame(door).centre).y;
  };
  document.apply(Play{});
  play(document, 0.5);
  EXPECT_NEAR(depth(), 0.26, 0.005);
  burn_hinge(document, 0.3);
  EXPECT_EQ(held_joints(document.world()).size(), 1u);
  document.apply(Play{});
  play(document, 1);
  EXPECT_LT(depth(), 0.3);
  burn_hinge(document, -0.3);
  EXPECT_TRUE(held_joints(document.world()).empty());
  const double before = depth();
  document.apply(Play{});
  play(document, 0.5);
  EXPECT_GT(depth() - before, 0.8 * 9.81 * 0.5 * 0.5 / 2);
}

TEST(Joints, a_sleeping_door_wakes_when_its_frame_loses_its_faces) {
  Document document = door_on_two_hinges();
  const auto door = [&]() -> const Body& { return document.world().body(document.world().ids()[1]); };
  document.apply(Play{});
  play(document, 3);
  EXPECT_TRUE(door().motion.asleep);
  const size_t faces = door().mesh.live_faces();
  CutSettings settings;
  settings.laser.radius = 0.125;
  settings.laser.range = {0, 3};
  settings.resolution.target_edge = 0.02;
  for (const double x : {-0.3, 0.3}) {
    document.apply(BeginStroke{settings, {{x, 0.12, 1}, {0, 0, -1}}});
    document.apply(MoveBeam{{{x, 0.121, 1}, {0, 0, -1}}});
    document.apply(EndStroke{});
    ASSERT_TRUE(test::run_all(document).ok());
  }
  EXPECT_TRUE(held_joints(document.world()).empty());
  EXPECT_EQ(door().mesh.live_faces(), faces);
  const double before = door().placement.position.y;
  document.apply(Play{});
  play(document, 0.5);
  EXPECT_LT(door().placement.position.y - before, -0.8 * 9.81 * 0.5 * 0.5 / 2);
}

TEST(Joints, undo_restores_a_hanging_door_and_redo_repeats_its_fall_exactly) {
  Document document = door_on_two_hinges();
  document.apply(Play{});
  play(document, 0.25);
  const uint64_t hanging = state_hash(document.world());
  burn_hinge(document, 0.3);
  burn_hinge(document, -0.3);
  document.apply(Play{});
  play(document, 0.5);
  const uint64_t fallen = state_hash(document.world());
  const size_t steps = document.history().position();
  ASSERT_TRUE(document.travel(steps - 3).ok());
  EXPECT_EQ(state_hash(document.world()), hanging);
  EXPECT_EQ(held_joints(document.world()).size(), 2u);
  ASSERT_TRUE(document.travel(steps).ok());
  EXPECT_EQ(state_hash(document.world()), fallen);
}

TEST(Joints, physics_rebuilt_at_any_tick_continues_bit_for_bit) {
  Random random(7);
  World one = cart(), other = one;
  for (World* world : {&one, &other}) {
    world->set_environment({.gravity = {0, -9.81, 0}, .ground = 0});
    for (const BodyId id : world->ids()) world->body(id).motion.velocity = {0.5, 0, 2};
  }
  Physics kept, made_anew;
  for (int t = 0; t < 200; ++t) {
    if (random.below(7) == 0) made_anew = Physics();
    kept.tick(one);
    made_anew.tick(other);
    ASSERT_EQ(state_hash(one), state_hash(other)) << "tick " << t;
  }
}

TEST(Joints, are_stored_once_per_pair_in_any_order) {
  test::MovingSheets sheets;
  for (int i = 0; i < 4; ++i) sheets.add(test::rectangle(0.1, 0.1, 1), {0.2 * i, 0, 0});
  const std::vector<MovingBody>& bodies = sheets.bodies();
  const std::vector<BodyJoint> joints{{2, 3, nullptr}, {1, 0, nullptr}, {1, 2, nullptr},
                                      {3, 2, nullptr}, {0, 1, nullptr}, {0, 3, nullptr}};
  ContactMemory memory;
  for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {2, 3}}) {
    memory.push_back({bodies[i].id, bodies[j].id, {}, {}, {}});
    memory.back().crossed = 5;
  }
  remember_joints(bodies, joints, memory);
  std::vector<std::pair<BodyId, BodyId>> pairs, expected;
  for (const PairMemory& m : memory) {
    pairs.push_back(m.bodies());
    const bool joined = m.bodies() != std::pair(bodies[0].id, bodies[2].id);
    EXPECT_EQ(m.touching, joined);
    EXPECT_EQ(m.crossed, joined ? 0u : 5u);
  }
  for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}})
    expected.emplace_back(bodies[i].id, bodies[j].id);
  EXPECT_EQ(pairs, expected);
}

TEST(Physics, rebuilds_a_collider_and_keeps_joints_on_a_change_without_faces) {
  World world;
  const BodyId id = test::add(world, test::rectangle(1, 1, 4), Vec3(0));
  Physics physics;
  physics.tick(world);
  ASSERT_TRUE(physics.has_joints_cached());
  ASSERT_FALSE(physics.needs_collider(world, id, false));
  Delta delta;
  delta.bodies.emplace_back().body = id;
  physics.follow(delta);
  EXPECT_TRUE(physics.has_joints_cached());
  EXPECT_TRUE(physics.needs_collider(world, id, false));
  delta.bodies[0].dead = {FaceId(0)};
  physics.follow(delta);
  EXPECT_FALSE(physics.has_joints_cached());
}

}  // namespace
}  // namespace kerf
