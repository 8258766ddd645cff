#include "ui/editor/marks/legends.h"

#include <gtest/gtest.h>

#include "ui/render/view_switches.h"

namespace kerf {
namespace {

ViewOptions plain() {
  ViewOptions look;
  look.level_colours = false;
  return look;
}

TEST(Legends, every_view_with_colours_of_its_own_has_a_title_and_says_what_they_mean) {
  EXPECT_TRUE(legends_of(plain(), {}, true).empty());
  for (const SwitchId id :
       {SwitchId::kSilhouette, SwitchId::kShadowVolumes, SwitchId::kShadowCounts, SwitchId::kFacing,
        SwitchId::kCompare, SwitchId::kTrace, SwitchId::kLevelColours, SwitchId::kBoxes, SwitchId::kBoxesHit,
        SwitchId::kPieces, SwitchId::kFaceNumbers}) {
    ViewOptions look = plain();
    view_switch(id).set(look, 1);
    const std::vector<Legend> legends = legends_of(look, {}, true);
    ASSERT_EQ(legends.size(), 1u) << view_switch(id).report;
    EXPECT_FALSE(legends[0].title.empty());
    EXPECT_FALSE(legends[0].rows.empty());
  }
}

TEST(Legends, what_only_a_cut_colours_has_none_before_the_first_stroke) {
  ViewOptions look = plain();
  look.level_colours = true;
  EXPECT_TRUE(legends_of(look, {}, false).empty());
}

TEST(Legends, the_boxes_say_which_of_them_are_drawn) {
  ViewOptions look = plain();
  look.show.aabb = true;
  look.tree.deepest = 3;
  EXPECT_EQ(legends_of(look, {}, true).at(0).rows.size(), 3u);
  look.tree.hit_only = true;
  EXPECT_EQ(legends_of(look, {}, true).at(0).rows.size(), 2u);
}

TEST(Legends, the_comparison_says_what_it_counts) {
  ViewOptions look = plain();
  look.show.shadow_compare = true;
  ShadowFigures figures;
  figures.differing = 1234;
  const Legend legend = legends_of(look, figures, true).at(0);
  EXPECT_NE(legend.rows[2].meaning.find("1 234 pixels"), std::string::npos);
}

}  // namespace
}  // namespace kerf
