#include "core/document/commands.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(CommandWords, are_for_people) {
  CutSettings settings;
  settings.laser.radius = 0.004;
  EXPECT_EQ(words(BeginStroke{settings, {}}, FileUnit::kMetre), "Stroke, radius 4 mm");
  EXPECT_EQ(words(HidePiece{{{0, 0}, 2}, true}, FileUnit::kMetre), "Hide piece 2 of body 1");
  EXPECT_EQ(words(DuplicatePiece{{{1, 0}, 0}, {}}, FileUnit::kMetre), "Duplicate body 2");
  EXPECT_GT(weight(RenamePiece{{{0, 0}, 1}, std::string(100, 'x')}), 100u);
}

TEST(CommandWords, name_lengths_in_the_unit_in_which_the_work_is_shown) {
  CutSettings settings;
  settings.laser.radius = 0.01;
  settings.resolution.rule = Resolution::Rule::kTargetEdge;
  settings.resolution.target_edge = 0.5;
  EXPECT_EQ(words(BeginStroke{settings, {}}, FileUnit::kMillimetre), "Stroke, radius 10 \xc2\xb5m");
  EXPECT_EQ(words(BeginStroke{settings, {}}, FileUnit::kInch), "Stroke, radius 0.01 in");
  EXPECT_EQ(words(Recut{settings}, FileUnit::kMillimetre), "Cut the stroke again, edges of 500 \xc2\xb5m");
}

}  // namespace
}  // namespace kerf
