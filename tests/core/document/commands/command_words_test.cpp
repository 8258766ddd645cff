#include "core/document/commands/command_words.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(CommandWords, are_for_people) {
  CutSettings settings;
  settings.laser.radius = 0.004;
  EXPECT_EQ(words(BeginStroke{settings, {}}), "Stroke, radius 4 mm");
  EXPECT_EQ(words(HidePiece{{{0, 0}, 2}, true}), "Hide piece 2 of body 1");
  EXPECT_EQ(words(DuplicatePiece{{{1, 0}, 0}, {}}), "Duplicate body 2");
  EXPECT_GT(weight(RenamePiece{{{0, 0}, 1}, std::string(100, 'x')}), 100u);
}

}  // namespace
}  // namespace kerf
