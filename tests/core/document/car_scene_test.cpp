#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/ids.h"
#include "core/document/document.h"
#include "core/document/scene.h"
#include "core/joints/joined_parts.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/world.h"
#include "tests/support/checkout.h"
#include "tests/support/strokes.h"

namespace kerf {
namespace {

Document car() {
  auto scene = read_scene(test::checkout() / "assets/scenes/car.json");
  EXPECT_TRUE(scene.ok()) << scene.error().message;
  return Document(std::move(scene->world));
}

void stroke(Document& document, const Vec3& from, const Vec3& to, const Vec3& direction, double radius,
            double target_edge = 0.03) {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, 10};
  settings.resolution.target_edge = target_edge;
  document.apply(BeginStroke{settings, {from, direction}});
  document.apply(MoveBeam{{to, direction}});
  document.apply(EndStroke{});
  ASSERT_TRUE(test::run_all(document).ok());
}

void play(Document& document, Ticks ticks) {
  document.apply(Play{});
  document.apply(AdvanceTime{ticks, true});
  ASSERT_TRUE(test::run_all(document).ok());
}

TEST(CarScene, all_parts_are_joined_and_the_mass_is_the_sum_of_its_sheets) {
  const Document document = car();
  const World& world = document.world();
  EXPECT_EQ(held_joints(world).size(), world.joints().all.size());
  EXPECT_EQ(world.live_pieces(), 1u);
  const Body& body = world.body(world.ids()[0]);
  EXPECT_NEAR(rigid_frame(body).mass, 0.0008 * 7850 * body.loaded.area, 1e-6);
}

TEST(CarScene, nothing_floats_after_the_car_is_cut_in_two) {
  Document document = car();
  stroke(document, {-1.5, 3, 0.485}, {1.5, 3, 0.485}, {0, -1, 0}, 0.01);
  const World& world = document.world();
  EXPECT_EQ(held_joints(world).size(), world.joints().all.size());
  // All that lies ahead of the cut belongs to one piece, with the steering wheel, and the rest to the other.
  const Body& body = world.body(world.ids()[0]);
  EXPECT_EQ(world.live_pieces(), 2u);
  std::set<std::pair<bool, uint32_t>> sides;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const double z = body.mesh.triangle(FaceId(f))[0].z;
    if (z < 0.2 || z > 0.5) sides.emplace(z > 0.5, body.label(FaceId(f)));
  }
  EXPECT_EQ(sides.size(), 2u);
}

TEST(CarScene, a_standing_car_settles_on_wheels_that_turn) {
  Document document = car();
  document.apply(Command(SetEnvironment{{.gravity = {0, -9.81, 0}, .ground = -0.001}}));
  play(document, 1200);
  const World& world = document.world();
  EXPECT_EQ(world.ids().size(), 6u);
  EXPECT_LT(glm::length(world.body(world.ids()[0]).placement.position), 0.2);
  size_t turning = 0;
  for (const HeldJoint& held : held_joints(world)) {
    if (held.parts[0].body == held.parts[1].body) continue;
    const Vec3 anchor = world.joints().all[held.joint].anchor;
    const Vec3 first = world.body(held.parts[0].body).placement.to_world(anchor);
    EXPECT_LT(glm::length(first - world.body(held.parts[1].body).placement.to_world(anchor)), 0.002);
    ++turning;
  }
  EXPECT_EQ(turning, 5u);
  for (const BodyId id : world.ids()) EXPECT_TRUE(world.body(id).motion.asleep) << id.slot;
}

TEST(CarScene, joints_do_not_affect_a_cut_while_time_is_paused) {
  Document with = car();
  auto mesh = read_scene(test::checkout() / "assets/meshes/car.obj");
  ASSERT_TRUE(mesh.ok());
  Document without(std::move(mesh->world));
  for (Document* document : {&with, &without}) {
    stroke(*document, {-1.5, 3, 0.2}, {1.5, 3, -0.1}, {0, -1, 0}, 0.02);
    stroke(*document, {3, 0.3, 1.2}, {3, 0.35, 1.4}, {-1, 0, 0}, 0.1);
  }
  EXPECT_GT(with.world().live_pieces(), 2u);
  EXPECT_EQ(state_hash(with.world()), state_hash(without.world()));
}

TEST(CarScene, a_wheel_with_a_burnt_hub_comes_off) {
  Document document = car();
  document.apply(Command(SetEnvironment{{.gravity = {0, -9.81, 0}, .ground = -0.001}}));
  const auto wheels = [&] {
    size_t held = 0;
    for (const HeldJoint& h : held_joints(document.world()))
      held += document.world().joints().all[h.joint].kind == Joint::Kind::kHub;
    return held;
  };
  EXPECT_EQ(wheels(), 5u);
  stroke(document, {3, 0.3185, 1.3}, {3, 0.3185, 1.301}, {-1, 0, 0}, 0.2);  // both front wheels
  EXPECT_EQ(wheels(), 3u);
  play(document, 240);
  // Without its front wheels the car drops onto its nose.
  EXPECT_LT(document.world().body(document.world().ids()[0]).placement.to_world({0, 0.3, 2}).y, 0.27);
}

// The height of the lowest point of the half of a car that lies ahead of or behind z in its own frame.
double lowest_point(const World& world, bool ahead, double z) {
  constexpr double kWide = 1;  // m, unlike a wheel
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    Interval width{10, -10};
    double lowest = 10;
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      for (const Vec3& p : body.mesh.triangle(FaceId(f))) {
        width = {std::min(width.low, p.x), std::max(width.high, p.x)};
        lowest = std::min(lowest, body.placement.to_world(p).y);
      }
    }
    if (width.high - width.low > kWide && (rigid_frame(body).centre.z > z) == ahead) return lowest;
  }
  ADD_FAILURE() << "no such half";
  return 0;
}

// A cut at -0.1 goes through the pins of the hinges of the rear doors. After one at -0.9 the rear half stands
// in balance on its axle, with the rear seat on its floor; after a fine one at 0 the roofs stay caught in
// each other.
TEST(CarScene, the_halves_of_a_car_roll_apart_and_drop_to_the_ground) {
  struct Cut {
    double z, target_edge;
  };
  for (const Cut cut : {Cut{-0.3, 0.0015}, {-0.1, 0.0015}, {0, 0.03}, {0.2, 0.0015}, {0.5, 0.0015}}) {
    SCOPED_TRACE("z " + std::to_string(cut.z) + ", target edge " + std::to_string(cut.target_edge));
    Document document = car();
    document.apply(Command(SetEnvironment{{.gravity = {0, -9.81, 0}, .ground = 0}}));
    stroke(document, {-1.5, 3, cut.z}, {1.5, 3, cut.z}, {0, -1, 0}, 0.006, cut.target_edge);
    play(document, 6 * kTicksPerSecond);
    for (const bool ahead : {false, true})
      EXPECT_NEAR(lowest_point(document.world(), ahead, cut.z), 0, 0.03) << (ahead ? "ahead" : "behind");
  }
}

}  // namespace
}  // namespace kerf
