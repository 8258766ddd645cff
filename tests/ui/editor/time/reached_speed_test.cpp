#include "ui/editor/time/play_controls.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(ReachedSpeed, is_simulated_seconds_per_second) {
  ReachedSpeed speed;
  Ticks clock = 100;
  speed.follow(true, clock, 0.1);
  EXPECT_FALSE(speed.of_real_time()) << "nothing is measured yet";
  for (int frame = 0; frame < 10; ++frame) speed.follow(true, clock += kTicksPerSecond / 40, 0.1);
  ASSERT_TRUE(speed.of_real_time());
  EXPECT_NEAR(*speed.of_real_time(), 0.25, 1e-9);
}

TEST(ReachedSpeed, resets_on_each_play_and_when_time_is_undone) {
  ReachedSpeed speed;
  Ticks clock = 0;
  const auto play_a_second = [&] {
    for (int frame = 0; frame < 10; ++frame) speed.follow(true, clock += 12, 0.1);
  };
  speed.follow(true, clock, 0.1);
  play_a_second();
  EXPECT_TRUE(speed.of_real_time());
  speed.follow(false, clock, 0.1);
  EXPECT_FALSE(speed.of_real_time());
  speed.follow(true, clock, 0.1);
  play_a_second();
  clock = 0;
  speed.follow(true, clock, 0.1);
  EXPECT_FALSE(speed.of_real_time()) << "undo took time back";
}

}  // namespace
}  // namespace kerf
