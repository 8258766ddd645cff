#include "ui/game/player_input.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"
#include "tests/support/game_files.h"
#include "ui/game/game_actions.h"

namespace kerf {
namespace {

InputEvent moved_to(double x, double y) {
  InputEvent event;
  event.at = {x, y};
  return event;
}

InputEvent event_of(InputEvent::Kind kind, int button) {
  InputEvent event;
  event.kind = kind;
  event.button = event.place = button;
  return event;
}

// The presses that a match sees: states that are on after one that is off.
int rising_edges(PlayerInput& input, bool Controls::*member) {
  int edges = 0;
  bool before = false;
  for (int t = 0; t < 10; ++t) {
    const bool now = input.controls({}).*member;
    edges += now && !before;
    before = now;
  }
  return edges;
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

TEST(PlayerInput, two_taps_between_two_ticks_are_two_presses) {
  using Kind = InputEvent::Kind;
  PlayerInput input;
  const InputEvent down = event_of(Kind::kKey, GLFW_KEY_V), up = event_of(Kind::kKeyUp, GLFW_KEY_V);
  input.handle_events(std::vector{down, up, down, up}, {});
  EXPECT_EQ(rising_edges(input, &Controls::spawn), 2);
  input.handle_events(std::vector{event_of(Kind::kPress, 0), event_of(Kind::kRelease, 0)}, {});
  EXPECT_EQ(rising_edges(input, &Controls::fire), 1);
}

TEST(PlayerInput, an_action_with_two_keys_is_held_until_both_are_released) {
  using Kind = InputEvent::Kind;
  PlayerInput input;
  input.handle_events(std::vector{event_of(Kind::kKey, GLFW_KEY_W), event_of(Kind::kKey, GLFW_KEY_UP)}, {});
  for (int t = 0; t < 4; ++t) (void)input.controls({});
  input.handle_events(std::vector{event_of(Kind::kKeyUp, GLFW_KEY_W)}, {});
  EXPECT_EQ(input.controls({}).throttle, Controls::kFull);
  input.handle_events(std::vector{event_of(Kind::kKeyUp, GLFW_KEY_UP)}, {});
  EXPECT_EQ(input.controls({}).throttle, 0);
}

TEST(ActionLatch, counts_a_key_that_is_already_held_once) {
  ActionLatch latch;
  latch.hold(GLFW_KEY_W);
  latch.hold(GLFW_KEY_UP);
  latch.press(GLFW_KEY_W);
  EXPECT_TRUE(latch.next());
  latch.release(GLFW_KEY_W);
  EXPECT_TRUE(latch.next()) << "the other key is held";
  latch.release(GLFW_KEY_UP);
  EXPECT_FALSE(latch.next());
}

TEST(PlayerInput, a_key_can_be_replaced_and_the_two_actions_swap) {
  GameSettings settings;
  bind(GameAction::kSpawn, GLFW_KEY_C, settings.keys);
  EXPECT_EQ(action_of_key(GLFW_KEY_C, settings.keys), GameAction::kSpawn);
  EXPECT_EQ(action_of_key(GLFW_KEY_V, settings.keys), GameAction::kCamera);
  const KeyBindings before = settings.keys;
  for (const int fixed : {GLFW_KEY_UP, GLFW_KEY_ESCAPE, GLFW_KEY_1, GLFW_KEY_ENTER})
    bind(GameAction::kSpawn, fixed, settings.keys);
  EXPECT_EQ(settings.keys, before);
}

TEST(PlayerInput, an_unplugged_gamepad_releases_throttle_and_fire) {
  PlayerInput input;
  GamepadState pad;
  pad.axes[GLFW_GAMEPAD_AXIS_LEFT_Y] = -1;
  pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = 1;
  input.apply_gamepad(pad, 0.1, {}, false);
  const Controls held = input.controls({});
  EXPECT_TRUE(held.fire);
  EXPECT_EQ(held.throttle, Controls::kFull);
  input.apply_gamepad({}, 0.1, {}, false);
  (void)input.controls({});
  const Controls released = input.controls({});
  EXPECT_FALSE(released.fire);
  EXPECT_EQ(released.throttle, 0);
}

// The player's car looks at an enemy 20 m ahead, and a little past its middle.
class AimAssist : public testing::Test {
 protected:
  AimAssist() {
    const Vec3 way = world().body(match_.vehicles()[1].chassis).placement.to_world({0, 0.8, 0}) - eye();
    input_.turn(wrapped(heading_of(way) - heading_of(input_.direction(own()))) + 0.03,
                pitch_of(glm::normalize(way)));
    before_ = input_.direction(own());
  }

  const World& world() const { return match_.world(); }
  const Placement& own() const { return world().body(match_.vehicles()[0].chassis).placement; }
  Vec3 eye() const { return own().to_world(match_.vehicles()[0].what().turret.barrel.pivot); }
  // How far help turns the aim in half a second [rad].
  double turned_by_help(double after) {
    const Sight sight(world());
    input_.help(match_, sight, after);
    before_ = input_.direction(own());
    for (int i = 0; i < 5; ++i) input_.help(match_, sight, 0.02);
    return glm::length(input_.direction(own()) - before_);
  }

  Match match_{{test::flat_rules(1, 1), 1, Difficulty::kNormal}};
  PlayerInput input_;
  Vec3 before_{0};
};

TEST_F(AimAssist, turns_the_aim_only_after_it_has_rested) {
  EXPECT_GT(turned_by_help(PlayerInput::kAimRest), 1e-3);
  input_.handle_events(std::vector{moved_to(0, 0), moved_to(1, 0)}, {});
  EXPECT_EQ(turned_by_help(0), 0) << "within 0.15 s of a motion";
}

TEST_F(AimAssist, never_turns_the_aim_while_the_player_fires) {
  input_.handle_events(std::vector{event_of(InputEvent::Kind::kPress, 0)}, {});
  EXPECT_EQ(turned_by_help(1), 0);
}

TEST_F(AimAssist, slows_a_stick_down_near_parts_and_never_pulls_on_a_gamepad) {
  const auto turned_by_stick = [&](bool friction) {
    GamepadState pad;
    pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_X] = 1;
    PlayerInput input;
    input.apply_gamepad(pad, 0.1, {}, friction);
    return std::abs(input.controls({}).heading * Controls::kAimStep);
  };
  EXPECT_NEAR(turned_by_stick(true) / turned_by_stick(false), PlayerInput::kFriction, 1e-3);
  const Sight sight(world());
  const Vec3 hub = in_world(world(), match_.vehicles()[1], match_.vehicles()[1].what().wheels[0].hub);
  const Vec3 aim = glm::normalize(hub - eye());
  EXPECT_TRUE(is_near_part(match_, sight, aim));
  EXPECT_FALSE(is_near_part(match_, sight, glm::normalize(aim + Vec3(0, 0.5, 0))));
  GamepadState pad;
  pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_X] = 0.2f;
  input_.apply_gamepad(pad, 1e-3, {}, false);
  EXPECT_EQ(turned_by_help(1), 0);
}

TEST(SteadyAim, lasts_two_seconds_and_refills_in_six) {
  SteadyAim steady;
  double on = 0;
  for (int i = 0; i < 400; ++i) {
    steady.advance(true, 0.01);
    on += steady.is_on() ? 0.01 : 0;
    if (i == 100) {
      EXPECT_NEAR(steady.aim_factor(), SteadyAim::kAim, 1e-3);
    }
  }
  EXPECT_NEAR(on, SteadyAim::kSeconds, 0.02) << "held after it is used up, it stays off";
  EXPECT_NEAR(steady.time_factor(), 1, 1e-3);
  steady.reset();
  for (int i = 0; i < 200; ++i) steady.advance(true, 0.01);
  double refill = 0;
  for (; steady.left() < 1 && refill < 10; refill += 0.01) steady.advance(false, 0.01);
  EXPECT_NEAR(refill, SteadyAim::kRefill, 0.05);
}

TEST(MenuPlace, of_the_button_that_pauses_is_that_of_the_replaced_key) {
  KeyBindings bindings = default_bindings();
  bind(GameAction::kPause, GLFW_KEY_O, bindings);
  EXPECT_EQ(action_of_key(menu_place(GLFW_GAMEPAD_BUTTON_START, bindings), bindings), GameAction::kPause);
  bind(GameAction::kPause, GLFW_KEY_R, bindings);  // also the key of a button that restarts the match
  EXPECT_FALSE(action_of_key(menu_place(GLFW_GAMEPAD_BUTTON_X, bindings), bindings).has_value());
}

TEST(GuideLines, name_the_buttons_of_a_gamepad_instead_of_keys) {
  KeyBindings bindings = default_bindings();
  bind(GameAction::kHandbrake, GLFW_KEY_J, bindings);
  for (const bool gamepad : {false, true}) {
    std::string all;
    for (const std::string& line : guide_lines(bindings, true, gamepad)) all += line + "\n";
    for (const auto action :
         {GameAction::kHandbrake, GameAction::kBoost, GameAction::kCamera, GameAction::kGuide}) {
      const auto says = [&](bool pad) {
        return all.find(control_label(action, bindings, pad) + ": ") != std::string::npos;
      };
      EXPECT_TRUE(says(gamepad)) << all;
      EXPECT_FALSE(says(!gamepad)) << all;
    }
    EXPECT_NE(all.find("Mouse") != std::string::npos, gamepad) << all;
  }
}

}  // namespace
}  // namespace kerf
