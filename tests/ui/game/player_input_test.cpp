#include "ui/game/player_input.h"

#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"

namespace kerf {
namespace {

InputEvent moved_to(double x, double y) {
  InputEvent event;
  event.at = {x, y};
  return event;
}

Placement turned(double heading) {
  Placement placement;
  placement.orientation = axis_angle({0, 1, 0}, heading);
  return placement;
}

TEST(PlayerInput, aims_forward_until_the_mouse_moves) {
  PlayerInput input;
  for (const double heading : {0.0, 1.0, -2.5, 3.0}) {
    const Vec3 ahead = turned(heading).orientation * Vec3(0, 0, 1);
    EXPECT_NEAR(glm::length(input.direction(turned(heading)) - ahead), 0, 1e-9);
    EXPECT_NEAR(wrapped(input.controls(turned(heading)).heading * Controls::kAimStep - heading), 0, 1e-4);
  }
}

TEST(PlayerInput, the_mouse_turns_the_aim_except_by_its_first_position) {
  PlayerInput input;
  const GameSettings settings;
  input.handle_events(std::vector{moved_to(500, 300)}, settings);
  EXPECT_EQ(input.controls({}).heading, 0);
  input.handle_events(std::vector{moved_to(600, 250)}, settings);
  EXPECT_LT(input.controls({}).heading, 0) << "to the right";
  EXPECT_GT(input.controls({}).pitch, 0);
  GameSettings inverted;
  inverted.invert = true;
  PlayerInput other;
  other.handle_events(std::vector{moved_to(500, 300), moved_to(600, 250)}, inverted);
  EXPECT_EQ(other.controls({}).heading, input.controls({}).heading);
  EXPECT_LT(other.controls({}).pitch, 0);
}

TEST(PlayerInput, stays_within_the_turret_limits) {
  PlayerInput input;
  input.limit({-0.5, 0.5}, {-0.1, 0.2});
  input.turn(4, 4);
  EXPECT_NEAR(input.controls({}).heading * Controls::kAimStep, 0.5, 1e-4);
  EXPECT_NEAR(input.controls({}).pitch * Controls::kAimStep, 0.2, 1e-4);
  input.limit({-kPi, kPi}, {-0.1, 0.2});
  input.turn(3, -4);
  EXPECT_NEAR(input.controls({}).heading * Controls::kAimStep, 3.5 - 2 * kPi, 1e-4);
}

TEST(PlayerInput, the_wheel_sets_the_beam_width_within_its_bounds) {
  PlayerInput input;
  InputEvent wheel;
  wheel.kind = InputEvent::Kind::kWheel;
  wheel.wheel = 100;
  input.handle_events(std::vector{wheel}, {});
  EXPECT_EQ(input.controls({}).width, Controls::kFull);
  wheel.wheel = -100;
  input.handle_events(std::vector{wheel}, {});
  EXPECT_EQ(input.controls({}).width, 0);
}

}  // namespace
}  // namespace kerf
