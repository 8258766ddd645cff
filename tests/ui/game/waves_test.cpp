#include "ui/game/sounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

struct Sound {
  const char* name;
  Wave wave;
  bool loop;
};

std::vector<Sound> all_sounds() {
  return {{"engine", engine_loop(), true},         {"laser", laser_loop(), true},
          {"cutting", cutting_loop(), true},       {"warning", warning_loop(), true},
          {"impact", impact_sound(), false},       {"sheet", sheet_sound(), false},
          {"explosion", explosion_sound(), false}, {"good", chime_sound(true), false},
          {"bad", chime_sound(false), false}};
}

double loudness(const Wave& wave) {
  double sum = 0;
  for (const float x : wave) sum += double{x} * x;
  return std::sqrt(sum / static_cast<double>(wave.size()));
}

TEST(Waves, are_finite_bounded_and_audible) {
  for (const Sound& s : all_sounds()) {
    for (const float x : s.wave) ASSERT_TRUE(std::isfinite(x) && std::abs(x) <= 1) << s.name;
    EXPECT_GT(loudness(s.wave), 0.02) << s.name;
  }
}

TEST(Waves, loops_are_seamless_and_last_a_second) {
  for (const Sound& s : all_sounds()) {
    if (!s.loop) continue;
    EXPECT_EQ(s.wave.size(), size_t{kSampleRate}) << s.name;
    float largest = 0;
    for (size_t i = 1; i < s.wave.size(); ++i)
      largest = std::max(largest, std::abs(s.wave[i] - s.wave[i - 1]));
    EXPECT_LE(std::abs(s.wave.front() - s.wave.back()), largest) << s.name;
  }
}

TEST(Waves, one_shot_sounds_begin_and_end_in_silence) {
  for (const Sound& s : all_sounds()) {
    if (s.loop) continue;
    EXPECT_LT(std::abs(s.wave.front()), 0.01f) << s.name;
    EXPECT_LT(std::abs(s.wave.back()), 0.01f) << s.name;
  }
}

TEST(CuttingGain, fades_with_time_at_every_frame_rate) {
  const double once = faded_cutting_gain(0.8, 0.125);
  EXPECT_LT(once, 0.5 * 0.8);
  EXPECT_DOUBLE_EQ(faded_cutting_gain(faded_cutting_gain(0.8, 0.0625), 0.0625), once);
}

TEST(Waves, are_deterministic) { EXPECT_EQ(cutting_loop(), cutting_loop()); }

TEST(Waves, int16_conversion_covers_the_whole_sample_range) {
  EXPECT_EQ(to_16_bits(Wave{0, 1, -1, 2, -3}), (std::vector<int16_t>{0, 32767, -32767, 32767, -32767}));
}

}  // namespace
}  // namespace kerf
