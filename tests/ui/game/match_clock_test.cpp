#include "ui/game/match_picture.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace kerf {
namespace {

TEST(MatchClock, advances_as_many_ticks_as_the_frames_last) {
  MatchClock clock;
  Random random(41);
  double seconds = 0;
  int ticks = 0;
  for (int i = 0; i < 1000; ++i) {
    const double frame = random.uniform(0.001, 0.06);
    seconds += frame;
    ticks += clock.advance(frame);
    EXPECT_EQ(clock.dropped(), 0);
  }
  EXPECT_NEAR(ticks, 120 * seconds, 1.5);
}

TEST(MatchClock, drops_ticks_of_long_frames_for_good) {
  MatchClock clock;
  EXPECT_EQ(clock.advance(0.5), MatchClock::kMaxTicks);
  EXPECT_EQ(clock.dropped(), 60 - MatchClock::kMaxTicks);
  EXPECT_LE(clock.advance(1.0 / 60), 2);
}

TEST(MatchClock, reports_the_achieved_fraction_of_real_time) {
  MatchClock clock;
  for (int i = 0; i < 200; ++i) clock.advance(1.0 / 60);
  EXPECT_NEAR(clock.speed(), 1, 1e-9);
  for (int i = 0; i < 50; ++i) clock.advance(0.2);  // 24 ticks are due, 8 are played
  EXPECT_NEAR(clock.speed(), MatchClock::kMaxTicks / 24.0, 0.02);
  for (int i = 0; i < 500; ++i) clock.advance(1.0 / 60);
  EXPECT_NEAR(clock.speed(), 1, 0.01);
}

TEST(MatchClock, runs_at_quarter_speed_in_slow_motion) {
  MatchClock clock;
  clock.slow_down(0.5);
  int ticks = 0;
  for (int i = 0; i < 30; ++i) ticks += clock.advance(1.0 / 60);
  EXPECT_NEAR(ticks, 15, 1);
  EXPECT_FALSE(clock.slow_left() > 1e-9);
  ticks = 0;
  for (int i = 0; i < 30; ++i) ticks += clock.advance(1.0 / 60);
  EXPECT_NEAR(ticks, 60, 1);
}

TEST(MatchClock, a_shorter_slow_motion_does_not_end_a_longer_one) {
  MatchClock clock;
  clock.slow_down(3);
  clock.slow_down(1.2);
  EXPECT_EQ(clock.slow_left(), 3);
  clock.slow_down(4);
  EXPECT_EQ(clock.slow_left(), 4);
}

TEST(MatchClock, stops_for_a_moment_and_follows_its_pace) {
  MatchClock clock;
  clock.stop(0.05);
  EXPECT_EQ(clock.advance(0.025), 0);
  EXPECT_EQ(clock.pace(), 0);
  EXPECT_EQ(clock.advance(0.05), 3) << "half of this time is stopped";
  clock.set_pace(0.6);
  int ticks = 0;
  for (int i = 0; i < 50; ++i) ticks += clock.advance(0.02);
  EXPECT_NEAR(ticks, 72, 1);
}

}  // namespace
}  // namespace kerf
