#include <gtest/gtest.h>

#include "ui/game/match_picture.h"

namespace kerf {
namespace {

TEST(PresetChoice, stays_at_the_best_while_pictures_are_fast) {
  PresetChoice choice(false);
  for (int i = 0; i < 200; ++i) choice.took(i % 50 == 0 ? 0.2 : 0.016);
  EXPECT_EQ(choice.choose(PicturePreset::kAutomatic), PicturePreset::kHigh);
}

TEST(PresetChoice, goes_down_to_the_lowest_where_all_are_slow) {
  PresetChoice choice(false);
  int pictures = 0;
  while (choice.choose(PicturePreset::kAutomatic) != PicturePreset::kLow && pictures < 100) {
    choice.took(0.15);
    ++pictures;
  }
  EXPECT_LE(pictures, 16);
  for (int i = 0; i < 100; ++i) choice.took(0.15);
  EXPECT_EQ(choice.choose(PicturePreset::kAutomatic), PicturePreset::kLow);
}

TEST(PresetChoice, begins_with_the_lowest_without_a_graphics_card) {
  EXPECT_EQ(PresetChoice(true).choose(PicturePreset::kAutomatic), PicturePreset::kLow);
}

TEST(PresetChoice, obeys_a_setting) {
  PresetChoice choice(false);
  for (int i = 0; i < 100; ++i) choice.took(1);
  EXPECT_EQ(choice.choose(PicturePreset::kHigh), PicturePreset::kHigh);
}

}  // namespace
}  // namespace kerf
