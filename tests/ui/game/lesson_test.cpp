#include "ui/game/hud.h"

#include <gtest/gtest.h>

#include <GLFW/glfw3.h>

#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/game/vehicle/vehicle.h"
#include "tests/support/checkout.h"

namespace kerf {
namespace {

class LessonTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto rules = load_rules(test::checkout() / "assets/games/lesson.json");
    ASSERT_TRUE(rules) << rules.error().message;
    match_ = std::make_unique<Match>(MatchSetup{*rules, 1, Difficulty::kNormal});
    lesson_.emplace(*match_);
  }

  // Puts the player's car at a place, as driving there takes longer.
  void move_to(const Vec3& place) {
    auto& world = const_cast<World&>(match_->world());
    Body& chassis = world.body(match_->vehicles()[Match::kPlayer].chassis);
    chassis.placement.position = {place.x, chassis.placement.position.y, place.z};
    chassis.motion = {};
  }

  // Draws the beam to and fro and up and down across a place, until a task is done. Returns whether one was.
  bool cut_at(const Vec3& at) {
    for (int t = 0; t < 480; ++t) {
      const Vec3 from =
          in_world(match_->world(), match_->vehicles()[0], match_->vehicles()[0].what().turret.barrel.pivot);
      const Vec3 way = at - from;
      Controls controls;
      controls.heading = static_cast<int32_t>(
          std::lround((heading_of(way) + 0.12 * std::sin(0.05 * t)) / Controls::kAimStep));
      controls.pitch = static_cast<int32_t>(
          std::lround((pitch_of(way / glm::length(way)) + 0.05 * std::sin(0.031 * t)) / Controls::kAimStep));
      controls.fire = t > 60;
      controls.width = 60;
      match_->tick(controls);
      if (lesson_->on_tick(*match_)) return true;
    }
    return false;
  }

  std::unique_ptr<Match> match_;
  std::optional<Lesson> lesson_;
};

TEST_F(LessonTest, names_the_controls_of_the_player) {
  KeyBindings keys = default_bindings();
  bind(GameAction::kForward, GLFW_KEY_I, keys);
  EXPECT_EQ(lesson_->task(*match_, keys, false)->text, "Drive to the marker (I A S D)");
  EXPECT_EQ(lesson_->task(*match_, keys, true)->text, "Drive to the marker (Left stick)");
}

TEST_F(LessonTest, advances_from_hitting_a_drum_to_cutting_a_wheel) {
  const auto drive = lesson_->task(*match_);
  ASSERT_TRUE(drive);
  EXPECT_TRUE(drive->text.starts_with("Drive"));
  match_->tick({});
  EXPECT_FALSE(lesson_->on_tick(*match_)) << "it is not there yet";
  move_to(drive->at);
  match_->tick({});
  EXPECT_TRUE(lesson_->on_tick(*match_));

  const auto drum = lesson_->task(*match_);
  ASSERT_TRUE(drum);
  EXPECT_LT(glm::distance(drum->at, drive->at), 15) << "it is within range";
  EXPECT_TRUE(cut_at(drum->at));

  const auto car = lesson_->task(*match_);
  ASSERT_TRUE(car);
  move_to(car->at + Vec3(5, 0, 0));
  const Vec3 hub =
      in_world(match_->world(), match_->vehicles()[1], match_->vehicles()[1].what().wheels[0].hub);
  EXPECT_TRUE(cut_at(hub));
  EXPECT_TRUE(lesson_->done());
  EXPECT_FALSE(lesson_->task(*match_));
}

TEST_F(LessonTest, ends_if_the_car_has_lost_its_wheels_before) {
  move_to(lesson_->task(*match_)->at);
  match_->tick({});
  EXPECT_TRUE(lesson_->on_tick(*match_));
  EXPECT_TRUE(cut_at(lesson_->task(*match_)->at));
  ASSERT_FALSE(lesson_->done());
  for (Wheel& wheel : const_cast<Vehicle&>(match_->vehicles()[1]).wheels) wheel.attached = false;
  match_->tick({});
  EXPECT_TRUE(lesson_->on_tick(*match_));
  EXPECT_TRUE(lesson_->done());
}

}  // namespace
}  // namespace kerf
