#include "ui/editor/path/emitter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/random.h"

namespace kerf {
namespace {

// The times at which shots are fired, if polled at `times`.
std::vector<double> shots(FirePace& pace, const std::vector<double>& times) {
  std::vector<double> fired;
  for (const double now : times) {
    if (!pace.is_due(now)) continue;
    pace.take(now);
    fired.push_back(now);
  }
  return fired;
}

std::vector<double> every(double seconds, double from, double until) {
  std::vector<double> times;
  for (int i = 0; from + i * seconds <= until; ++i) times.push_back(from + i * seconds);
  return times;
}

TEST(FirePace, fires_a_fixed_number_of_shots_per_second_at_any_frame_rate) {
  for (const double per_second : {0.5, 3.0, 10.0}) {
    for (const double frame : {1.0 / 60, 1.0 / 37, 0.09}) {
      FirePace pace;
      pace.set(per_second);
      const size_t fired = shots(pace, every(frame, 7, 17)).size();
      EXPECT_NEAR(static_cast<double>(fired), 10 * per_second + 1, 1.01) << per_second << ", " << frame;
    }
  }
}

TEST(FirePace, keeps_its_rhythm_with_irregular_frames) {
  Random random(5);
  FirePace pace;
  pace.set(4);
  std::vector<double> frames{3};
  while (frames.back() < 33) frames.push_back(frames.back() + random.uniform(0.005, 0.1));
  const std::vector<double> fired = shots(pace, frames);
  ASSERT_EQ(fired.size(), 121u);
  for (size_t i = 0; i < fired.size(); ++i) {
    const double late = fired[i] - (3 + 0.25 * static_cast<double>(i));
    EXPECT_GE(late, -1e-9);
    EXPECT_LE(late, 0.1 + 1e-9);
  }
}

TEST(FirePace, skips_shots_missed_by_a_long_frame) {
  FirePace pace;
  pace.set(10);
  EXPECT_EQ(shots(pace, {0, 5.05, 5.06, 5.08, 5.11, 5.15}), (std::vector<double>{0, 5.05, 5.11}));
}

TEST(FirePace, fires_immediately_at_the_start_and_after_a_rate_increase) {
  FirePace pace;
  pace.set(0.1);
  EXPECT_EQ(shots(pace, {1, 2}), std::vector<double>{1});
  pace.set(2);
  EXPECT_EQ(shots(pace, {2.1}), std::vector<double>{2.1});
  pace.begin();
  EXPECT_EQ(shots(pace, {2.11}), std::vector<double>{2.11});
}

TEST(FirePace, is_limited) {
  FirePace pace;
  pace.set(1e9);
  EXPECT_EQ(pace.per_second(), FirePace::kFastest);
  pace.set(-1);
  EXPECT_EQ(pace.per_second(), FirePace::kSlowest);
}

}  // namespace
}  // namespace kerf
