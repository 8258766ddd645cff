#include <gtest/gtest.h>

#include "ui/game/match_picture.h"

namespace kerf {
namespace {

TEST(PresetChoice, stays_at_the_best_while_pictures_are_fast) {
  PresetChoice choice(false);
  for (int i = 0; i < 200; ++i) choice.took(i % 50 == 0 ? 0.2 : 0.016);
  EXPECT_EQ(choice.select(PicturePreset::kAutomatic), PicturePreset::kHigh);
}

TEST(PresetChoice, goes_down_to_the_lowest_where_all_are_slow) {
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

TEST(PresetChoice, begins_with_the_lowest_without_a_graphics_card) {
  EXPECT_EQ(PresetChoice(true).select(PicturePreset::kAutomatic), PicturePreset::kLow);
}

TEST(PresetChoice, obeys_a_setting) {
  PresetChoice choice(false);
  for (int i = 0; i < 100; ++i) choice.took(1);
  EXPECT_EQ(choice.select(PicturePreset::kHigh), PicturePreset::kHigh);
}

TEST(ResolutionChoice, goes_down_to_half_where_pictures_are_slow_and_up_to_all_where_they_are_fast) {
  ResolutionChoice choice;
  EXPECT_EQ(choice.share(), ResolutionChoice::kFirst);
  for (int i = 0; i < 100; ++i) choice.took(0.1);
  EXPECT_EQ(choice.share(), ResolutionChoice::kLeast);
  for (int i = 0; i < 1000; ++i) choice.took(0.01);
  EXPECT_EQ(choice.share(), 1);
}

TEST(ResolutionChoice, stays_while_single_pictures_are_slow) {
  ResolutionChoice choice;
  for (int i = 0; i < 200; ++i) choice.took(i % 5 == 0 ? 0.1 : 0.033);
  EXPECT_EQ(choice.share(), ResolutionChoice::kFirst);
}

}  // namespace
}  // namespace kerf
