#include <gtest/gtest.h>

#include "ui/game/match_picture.h"

namespace kerf {
namespace {

TEST(PresetChoice, stays_at_the_best_while_frames_are_fast) {
  PresetChoice choice(false);
  for (int i = 0; i < 200; ++i) choice.took(i % 50 == 0 ? 0.2 : 0.016);
  EXPECT_EQ(choice.select(PicturePreset::kAutomatic), PicturePreset::kHigh);
}

TEST(PresetChoice, drops_to_the_lowest_if_all_frames_are_slow) {
  PresetChoice choice(false);
  int pictures = 0;
  while (choice.select(PicturePreset::kAutomatic) != PicturePreset::kLow && pictures < 100) {
    choice.took(0.15);
    ++pictures;
  }
  EXPECT_LE(pictures, 16);
  for (int i = 0; i < 100; ++i) choice.took(0.15);
  EXPECT_EQ(choice.select(PicturePreset::kAutomatic), PicturePreset::kLow);
}

TEST(PresetChoice, starts_at_the_lowest_without_a_graphics_card) {
  EXPECT_EQ(PresetChoice(true).select(PicturePreset::kAutomatic), PicturePreset::kLow);
}

TEST(PresetChoice, respects_a_setting) {
  PresetChoice choice(false);
  for (int i = 0; i < 100; ++i) choice.took(1);
  EXPECT_EQ(choice.select(PicturePreset::kHigh), PicturePreset::kHigh);
}

TEST(ResolutionChoice, drops_to_half_for_slow_frames_and_returns_to_full_for_fast_ones) {
  ResolutionChoice choice;
  EXPECT_EQ(choice.share(), ResolutionChoice::kFirst);
  for (int i = 0; i < 100; ++i) choice.took(0.1);
  EXPECT_EQ(choice.share(), ResolutionChoice::kLeast);
  for (int i = 0; i < 1000; ++i) choice.took(0.01);
  EXPECT_EQ(choice.share(), 1);
}

TEST(ResolutionChoice, ignores_occasional_slow_frames) {
  ResolutionChoice choice;
  for (int i = 0; i < 200; ++i) choice.took(i % 5 == 0 ? 0.1 : 0.033);
  EXPECT_EQ(choice.share(), ResolutionChoice::kFirst);
}

}  // namespace
}  // namespace kerf
