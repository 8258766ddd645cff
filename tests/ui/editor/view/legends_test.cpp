#include "ui/editor/view/legends.h"

#include <gtest/gtest.h>

#include "ui/render/bodies/overlay_marks.h"
#include "ui/render/view/view_options.h"

namespace kerf {
namespace {

TEST(Legends, every_coloured_view_has_a_title_and_explains_its_colours) {
  EXPECT_TRUE(legends_of(ViewOptions(), {}).empty());
  for (const SwitchId id :
       {SwitchId::kSilhouette, SwitchId::kShadowVolumes, SwitchId::kShadowCounts, SwitchId::kFacing,
        SwitchId::kCompare, SwitchId::kTrace, SwitchId::kSizes, SwitchId::kBoxes, SwitchId::kBoxesHit,
        SwitchId::kPieces, SwitchId::kFaceNumbers}) {
    ViewOptions look;
    view_switch(id).set(look, 1);
    const std::vector<Legend> legends = legends_of(look, {});
    ASSERT_EQ(legends.size(), 1u) << view_switch(id).report;
    EXPECT_FALSE(legends[0].title.empty());
    EXPECT_FALSE(legends[0].rows.empty());
  }
}

TEST(Legends, the_scale_of_temperatures_descends_to_the_ambient_in_round_steps) {
  const auto meanings = [](double hottest) {
    std::vector<std::string> all;
    for (const Legend::Row& row : legend_of_heat(hottest).rows) all.push_back(row.meaning);
    return all;
  };
  using All = std::vector<std::string>;
  EXPECT_EQ(meanings(1811), (All{"1811 K, melting point", "1500 K", "1000 K", "500 K", "293 K"}));
  EXPECT_EQ(meanings(520), (All{"520 K, melting point", "400 K", "293 K"}));
}

TEST(Legends, shadow_colours_have_a_meaning_each) {
  ViewOptions look;
  look.show.shadow_stencil = look.show.silhouette = true;
  for (const Legend& legend : legends_of(look, {})) {
    for (const Legend::Row& row : legend.rows) EXPECT_TRUE(row.swatch) << row.meaning;
  }
  EXPECT_EQ(legends_of(look, {}).back().rows.back().meaning, "9 or more");
}

TEST(Legends, a_scalar_field_has_its_maximum_at_the_top) {
  ViewOptions look;
  ScalarField field;
  field.name = "Level";
  field.labels = {"0", "1", "2", "3", "4"};
  look.scalar = std::make_shared<const ScalarField>(field);
  const Legend legend = legends_of(look, {}).at(0);
  EXPECT_EQ(legend.title, "Level");
  EXPECT_EQ(legend.rows.front().meaning, "4");
  EXPECT_GT(legend.rows.front().colour & 0xff00u, legend.rows.back().colour & 0xff00u);
}

TEST(Legends, boxes_describe_which_of_them_are_drawn) {
  ViewOptions look;
  look.show.aabb = true;
  look.tree.deepest = 3;
  EXPECT_EQ(legends_of(look, {}).at(0).rows.size(), 4u);
  look.tree.hit_only = true;
  EXPECT_EQ(legends_of(look, {}).at(0).rows.size(), 2u);
}

TEST(Legends, the_comparison_describes_its_counts) {
  ViewOptions look;
  look.show.shadow_compare = true;
  ShadowStatistics statistics;
  EXPECT_EQ(legends_of(look, statistics).at(0).rows[2].meaning, "counting pixels that are in shadow with");
  statistics.differing = 1234;
  EXPECT_EQ(legends_of(look, statistics).at(0).rows[2].meaning, "1 234 pixels are in shadow with");
  statistics.differing = 1;
  EXPECT_EQ(legends_of(look, statistics).at(0).rows[2].meaning, "1 pixel is in shadow with");
}

TEST(Legends, shadow_rays_show_progress_until_the_result_is_complete) {
  ViewOptions look;
  look.show.shadow_reference = true;
  ShadowStatistics statistics;
  statistics.traced = 0.4;
  EXPECT_EQ(legends_of(look, statistics).at(0).rows[2].meaning, "viewport differs: tracing 40 %");
  statistics.traced = 1;
  statistics.wrong = 0;
  EXPECT_EQ(legends_of(look, statistics).at(0).rows[2].meaning, "viewport differs: 0 pixels");
}

TEST(Legends, a_single_step_stage_names_the_drawn_marks) {
  ViewOptions look;
  StageMarks marks;
  look.stage = std::make_shared<const StageMarks>(marks);
  EXPECT_TRUE(legends_of(look, {}).empty());
  marks.bodies.emplace_back().lines = {{.kind = StageMarks::Kind::kHit},
                                       {.kind = StageMarks::Kind::kRemoved}};
  marks.came_off = {{{0, 0}, 1}};
  marks.stayed = {{{0, 0}, 0}};
  look.stage = std::make_shared<const StageMarks>(marks);
  EXPECT_EQ(legends_of(look, {}).at(0).rows.size(), 4u);
}

}  // namespace
}  // namespace kerf
