#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/deterministic_math.h"
#include "core/cut/cut_step.h"
#include "core/game/arena/arena.h"
#include "core/game/match/match_world.h"
#include "core/game/vehicle/vehicle.h"
#include "core/game/vehicle/vehicle_dynamics.h"
#include "core/game/vehicle/vehicle_model.h"
#include "tests/support/checkout.h"

namespace kerf {
namespace {

// A van on a flat square, whose left door hangs on two hinges and a latch.
class Van : public testing::Test {
 protected:
  Van() {
    Arena arena;
    arena.description.size = {200, 200};
    world_ = MatchWorld(arena);
    auto file = read_vehicle(test::checkout() / "assets/vehicles/van.json");
    auto model = load_vehicle(std::move(*file));
    Delta created;
    van_ = add_vehicle(world_.world(), *model, Placement{}, MatchWorld::kGeneration, created);
    world_.make_colliders(carried_bodies(van_));
  }

  std::vector<KinematicBody> guided() const { return {{van_.chassis, true, 0}}; }
  const Body& chassis() const { return world_.world().body(van_.chassis); }

  // Burns a vertical slit into the left side of the van, through one sheet.
  void slit(double z, double from, double to) {
    const auto pose = [&](double y) { return Pose{Vec3(1.02, y, z), Vec3(-1, 0, 0)}; };  // of the van
    CutSettings settings;
    settings.laser.radius = 0.1;
    settings.laser.range = {0, 0.2};
    settings.resolution.rule = Resolution::Rule::kTolerance;
    settings.resolution.tolerance = 0.01;
    const BeamMove move{pose(from), pose(to), 0};
    auto cut = cut_without_separation(world_.world(), settings, van_.chassis, {&move, 1});
    ASSERT_TRUE(cut);
    ASSERT_GT(cut->delta.removed_faces, 0u);
    world_.follow(std::move(cut->delta));
  }

  // Returns what came off.
  std::vector<Detached> pass(int seconds, int throttle, int steer) {
    std::vector<Detached> off;
    van_.controls.throttle = static_cast<int8_t>(throttle);
    van_.controls.steer = static_cast<int8_t>(steer);
    for (Ticks t = 0; t < seconds * kTicksPerSecond; ++t) {
      world_.begin_tick(now_++);
      drive(world_.world(), van_, Sight(world_.world()));
      world_.renew_colliders();
      world_.move(guided(), carried_bodies(van_));
      place_carried(world_.world(), van_);
      for (const Detached& d : world_.separate()) off.push_back(d);
      world_.world().pass(1);
      for (const BodyId id : bodies_of_doors()) widest_ = std::max(widest_, opening(id));
    }
    return off;
  }

  // The bodies that were detached from the chassis.
  std::vector<BodyId> bodies_of_doors() const {
    std::vector<BodyId> all;
    for (const BodyId id : world_.world().ids()) {
      if (id != van_.chassis && world_.world().body(id).loaded_as == van_.chassis) all.push_back(id);
    }
    return all;
  }

  // rad, by which a body is turned against the chassis.
  double opening(BodyId id) const {
    const Body& body = world_.world().body(id);
    const double w = std::abs(glm::dot(body.placement.orientation, chassis().placement.orientation));
    return 2 * std::acos(std::min(1.0, w));
  }
  // m, between the places of a point of the frame of the van on a body and on the chassis.
  double gap(BodyId id, const Vec3& p) const {
    return glm::distance(world_.world().body(id).placement.to_world(p), chassis().placement.to_world(p));
  }

  static constexpr Vec3 kHinge{0.96, 0.62, 1.13};
  MatchWorld world_;
  Vehicle van_;
  Ticks now_ = 0;
  double widest_ = 0;
};

TEST_F(Van, keeps_latched_doors_shut) {
  slit(0.7, 0.9, 1.1);
  EXPECT_TRUE(pass(3, 100, 100).empty());
  EXPECT_TRUE(bodies_of_doors().empty());
}

TEST_F(Van, swings_an_unlatched_door_and_loses_it_with_its_hinges) {
  slit(0.2, 0.85, 1.15);
  EXPECT_TRUE(pass(4, 100, -100).empty());
  ASSERT_EQ(bodies_of_doors().size(), 1u);
  const BodyId door = bodies_of_doors().front();
  EXPECT_GT(widest_, radians_of(25));
  EXPECT_LT(widest_, radians_of(85));
  EXPECT_LT(gap(door, kHinge), 0.05);
  slit(1.17, 0.52, 1.1);
  const std::vector<Detached> off = pass(1, 0, 0);
  EXPECT_TRUE(std::ranges::any_of(off, [&](const Detached& d) { return d.to == door; }));
  EXPECT_GT(gap(door, kHinge), 0.2);
}

}  // namespace
}  // namespace kerf
