
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/base/deterministic_math.h"
#include "core/game/match/match.h"
#include "tests/support/checkout.h"
#include "tests/support/game_files.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

// For how long vehicles that can drive have wanted to, or lain on their side, and not got away.
class HeldVehicles {
 public:
  struct Times {
    double unhelped = 0;  // s, the longest of any vehicle since it was helped
    double all = 0;       // s, likewise with the time before that
  };
  // To be called after each tick.
  Times after(const Match& match) {
    if (match.delta().replaced) held_.clear();
    held_.resize(match.vehicles().size());
    for (const Event& e : match.events()) {
      if (e.kind == Event::Kind::kRighted) held_[e.vehicle].unhelped = 0;
    }
    Times longest;
    for (size_t v = 0; v < held_.size(); ++v) {
      const Held& held = count(match, v);
      longest.unhelped = std::max(longest.unhelped, seconds_of_ticks(held.unhelped));
      longest.all = std::max(longest.all, seconds_of_ticks(held.all));
    }
    return longest;
  }

 private:
  struct Held {
    Vec3 at{0};
    Ticks unhelped = 0, all = 0;
  };

  const Held& count(const Match& match, size_t v) {
    const Vehicle& vehicle = match.vehicles()[v];
    const Placement& placement = match.world().body(vehicle.chassis).placement;
    const bool lies = (placement.orientation * Vec3(0, 1, 0)).y < 0.3;
    const bool wants = lies || std::abs(vehicle.controls.throttle) > Controls::kFull / 5;
    const bool can = vehicle.alive && vehicle.can_drive();
    Held& held = held_[v];
    if (!can || glm::distance(placement.position, held.at) > 0.5) held = {placement.position};
    held.unhelped += wants;
    held.all += wants;
    return held;
  }

  std::vector<Held> held_;
};

// Five enemies at once, which get into each other's way. That a stuck vehicle is helped is what the tests
// below say.
TEST(Match, frees_every_stuck_vehicle_within_three_seconds) {
  const auto loaded = load_rules(test::checkout() / "assets/games/standard.json");
  ASSERT_TRUE(loaded) << loaded.error().message;
  auto rules = std::make_shared<Rules>(**loaded);
  rules->waves = {rules->waves.back()};
  constexpr std::array<uint64_t, 3> kSeeds{5, 6, 13};
  for (size_t i = 0; i < runs(kSeeds.size()); ++i) {
    const uint64_t seed = kSeeds[i];
    Match match({rules, seed, Difficulty::kNormal});
    BotPlayer bot(match);
    HeldVehicles held;
    for (int t = 0; t < 12 * static_cast<int>(kTicksPerSecond) && !match.standing().over(); ++t) {
      match.tick(bot.next(match));
      const HeldVehicles::Times times = held.after(match);
      ASSERT_LT(times.unhelped, 3.1) << "seed " << seed << ", tick " << t;
      ASSERT_LT(times.all, 4.5) << "seed " << seed << ", tick " << t;
    }
  }
}

// A vehicle that nothing moves but its recovery.
class Stuck : public testing::Test {
 protected:
  // Calls `each` before each tick of at most ten seconds. Returns the seconds until it is helped, or 10.
  template <typename Each>
  double seconds_until_helped(Each each) {
    for (Ticks t = 1; t < 10 * kTicksPerSecond; ++t) {
      each(t);
      if (recover_vehicle(lone_.world, lone_.vehicle, FreeSpace(), MatchTimes{})) return seconds_of_ticks(t);
    }
    return 10;
  }
  Body& chassis() { return lone_.world.body(lone_.vehicle.chassis); }
  void stand_on_wheels(bool all) {
    for (Wheel& wheel : lone_.vehicle.wheels) wheel.grounded = all;
  }
  void push(int throttle) { lone_.vehicle.controls.throttle = static_cast<int8_t>(throttle); }

  test::LoneVehicle lone_;
};

TEST_F(Stuck, a_vehicle_returns_to_its_last_free_place) {
  lone_.vehicle.free_place = Placement{{20, 0, 5}, {1, 0, 0, 0}};
  EXPECT_NEAR(seconds_until_helped([&](Ticks) { push(100); }), 3, 0.02);
  EXPECT_NEAR(glm::distance(chassis().placement.position, Vec3(20, 0, 5)), 0, 0.5);
}

TEST_F(Stuck, a_vehicle_that_shakes_between_gears_counts_as_stuck) {
  const auto tremble = [&](Ticks t) {
    push(t / 60 % 2 == 0 ? 100 : -100);
    chassis().motion.velocity = Vec3(t % 7 == 0 ? 2 : -2, 0, 0);
    chassis().placement.position.x = t % 2 == 0 ? 0.2 : -0.2;
  };
  EXPECT_NEAR(seconds_until_helped(tremble), 3, 0.02);
}

TEST_F(Stuck, a_vehicle_on_its_wheels_at_a_wall_gets_no_help) {
  stand_on_wheels(true);
  EXPECT_EQ(seconds_until_helped([&](Ticks) { push(100); }), 10);
}

TEST_F(Stuck, a_vehicle_with_a_waiting_driver_gets_no_help) {
  EXPECT_EQ(seconds_until_helped([&](Ticks) { push(0); }), 10);
}

TEST_F(Stuck, a_vehicle_without_driven_wheels_gets_no_help) {
  for (size_t i = 0; i < lone_.vehicle.wheels.size(); ++i)
    lone_.vehicle.wheels[i].attached = !lone_.vehicle.what().wheels[i].driven;
  EXPECT_EQ(seconds_until_helped([&](Ticks) { push(100); }), 10);
}

TEST_F(Stuck, a_vehicle_still_stuck_after_being_righted_is_moved_soon) {
  lone_.vehicle.free_place = Placement{{20, 0, 5}, {1, 0, 0, 0}};
  chassis().placement = {{3, 1.6, 4}, axis_angle({0, 0, 1}, kPi)};
  push(100);
  EXPECT_NEAR(seconds_until_helped([&](Ticks) {}), 3, 0.02);
  EXPECT_LT(chassis().placement.position.x, 4);
  EXPECT_NEAR(seconds_until_helped([&](Ticks) {}), 1.2, 0.02);
  EXPECT_GT(chassis().placement.position.x, 19);
}

TEST(Recovery, a_vehicle_on_its_roof_is_righted_after_a_while) {
  test::LoneVehicle lone;
  Body& chassis = lone.world.body(lone.vehicle.chassis);
  chassis.placement = {{3, 1.6, 4}, axis_angle({0, 0, 1}, kPi)};
  int ticks = 0;
  while (!recover_vehicle(lone.world, lone.vehicle, FreeSpace(), MatchTimes{}) && ticks < 1000) ++ticks;
  EXPECT_NEAR(ticks, 360, 2);
  EXPECT_GT((chassis.placement.orientation * Vec3(0, 1, 0)).y, 0.999);
  EXPECT_NEAR(chassis.placement.position.x, 3, 0.1);
}

TEST(Recovery, a_vehicle_without_wheels_stays_on_its_roof) {
  test::LoneVehicle lone;
  lone.world.body(lone.vehicle.chassis).placement = {{0, 1.6, 0}, axis_angle({0, 0, 1}, kPi)};
  for (Wheel& wheel : lone.vehicle.wheels) wheel.attached = false;
  for (int t = 0; t < 1000; ++t)
    ASSERT_FALSE(recover_vehicle(lone.world, lone.vehicle, FreeSpace(), MatchTimes{}));
}

}  // namespace
}  // namespace kerf
