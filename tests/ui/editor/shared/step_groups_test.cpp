#include "ui/editor/shared/world_changes.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "ui/editor/shared/statistics.h"

namespace kerf {
namespace {

class StepGroupsTest : public testing::Test {
 protected:
  StepGroupsTest() {
    World world;
    for (int i = 0; i < 3; ++i)
      pieces.push_back({world.add(make_body("sphere", test::build(test::sphere(6, 8, 1)))), {}});
    document = Document(std::move(world));
  }
  // Hides or shows some of the spheres, with one step each.
  void hide(bool hidden, size_t first, size_t end) {
    for (size_t i = first; i < end; ++i) ASSERT_TRUE(document.apply(HidePiece{pieces[i], hidden}).ok());
  }
  void hide_all(bool hidden) {
    const size_t from = document.history().position();
    hide(hidden, 0, 3);
    groups.add(from, document, hidden ? "Hide" : "Show");
  }
  const StepGroups::Group* at(bool back) {
    groups.follow(document);
    return groups.at(document.history().position(), back);
  }
  Document document;
  std::vector<PieceId> pieces;
  StepGroups groups;
};

TEST_F(StepGroupsTest, a_group_has_one_row_until_a_step_is_dropped) {
  hide_all(true);
  hide(false, 0, 2);
  groups.add(3, document, "Show");
  std::vector<bool> rows;
  for (size_t position = 0; position <= 5; ++position) rows.push_back(groups.has_row(position));
  EXPECT_EQ(rows, (std::vector<bool>{true, false, false, true, false, true}));
  ASSERT_TRUE(document.travel(4).ok());
  hide(false, 2, 3);
  groups.follow(document);
  EXPECT_TRUE(groups.has_row(4));
}

TEST_F(StepGroupsTest, the_marks_of_a_journal_restore_those_that_are_left) {
  std::vector<StateMark> marks;
  for (const bool hidden : {true, false, true}) {
    hide_all(hidden);
    if (!hidden) groups.mark(document, marks);  // two groups, and later the third
  }
  groups.mark(document, marks);
  EXPECT_EQ(marks.size(), 3u);
  ASSERT_TRUE(document.travel(7).ok());  // within the last group
  ASSERT_TRUE(document.travel(3).ok());
  StepGroups restored;
  restored.restore(document, marks);
  groups.follow(document);
  for (size_t position = 0; position <= 9; ++position)
    EXPECT_EQ(restored.has_row(position), groups.has_row(position)) << position;
  ASSERT_NE(restored.at(3, true), nullptr);
  EXPECT_EQ(restored.at(3, true)->name, "Hide");
  ASSERT_NE(restored.at(3, false), nullptr);
  EXPECT_EQ(restored.at(3, false)->name, "Show");
  hide(false, 0, 1);  // drops what is undone
  restored.restore(document, marks);
  EXPECT_NE(restored.at(3, true), nullptr);
  EXPECT_EQ(restored.at(3, false), nullptr);
}

TEST_F(StepGroupsTest, groups_are_undone_and_redone_one_by_one) {
  hide_all(true);
  hide_all(false);
  for (const size_t from : {3u, 0u}) {
    const StepGroups::Group* group = at(true);
    ASSERT_NE(group, nullptr);
    EXPECT_EQ(group->from, from);
    EXPECT_EQ(group->name, from == 3 ? "Show" : "Hide");
    ASSERT_TRUE(document.travel(from).ok());
  }
  EXPECT_EQ(at(true), nullptr);
  ASSERT_NE(at(false), nullptr);
  EXPECT_EQ(at(false)->to, 3u);
}

TEST_F(StepGroupsTest, a_single_step_is_not_a_group_and_a_later_step_is_undone_alone) {
  hide(true, 0, 1);
  groups.add(0, document, "Hide");
  EXPECT_EQ(at(true), nullptr);
  hide(false, 0, 1);
  hide_all(true);
  hide(false, 0, 1);
  EXPECT_EQ(at(true), nullptr);
  ASSERT_TRUE(document.apply(Undo{}).ok());
  EXPECT_NE(at(true), nullptr);
}

TEST_F(StepGroupsTest, a_group_ends_when_an_undone_step_is_replaced) {
  hide_all(true);
  for (const bool seen_between : {true, false}) {
    ASSERT_TRUE(document.apply(Undo{}).ok());
    if (seen_between) groups.follow(document);
    ASSERT_TRUE(document.apply(Redo{}).ok());
    EXPECT_NE(at(true), nullptr);
  }
  ASSERT_TRUE(document.apply(Undo{}).ok());
  hide(true, 2, 3);
  EXPECT_EQ(document.history().position(), 3u);
  EXPECT_EQ(at(true), nullptr);
}

TEST_F(StepGroupsTest, a_group_survives_undo_and_redo_of_its_last_step) {
  hide_all(true);
  ASSERT_TRUE(document.apply(Undo{}).ok());
  groups.follow(document);
  ASSERT_TRUE(document.apply(Redo{}).ok());
  hide(false, 0, 1);
  groups.follow(document);
  ASSERT_TRUE(document.apply(Undo{}).ok());
  EXPECT_NE(at(true), nullptr);
}

Document sphere_document() {
  World world;
  world.add(make_body("sphere", test::build(test::sphere(12, 16, 1))));
  return Document(std::move(world));
}

void drill(Document& document, double x) {
  CutSettings settings;
  settings.laser.radius = 0.1;
  ASSERT_TRUE(document.apply(BeginStroke{settings, {{x, 0, 5}, {0, 0, -1}}}).ok());
  ASSERT_TRUE(document.apply(EndStroke{}).ok());
  while (document.waiting() > 0) ASSERT_TRUE(document.step(8).ok());
}

TEST(StepGroups, the_last_cut_is_the_sum_over_its_group) {
  Document document = sphere_document();
  double area = 0;
  size_t faces = 0;
  for (const double x : {-0.5, 0.5}) {
    drill(document, x);
    area += document.history().last().totals().removed_area;
    faces += document.history().last().totals().statistics.faces_made;
  }
  StepGroups groups;
  ShownStatistics shown;
  record_stroke(shown, document.history(), groups);
  ASSERT_TRUE(shown.stroke);
  EXPECT_LT(shown.stroke->removed_area, 0.9 * area);
  groups.add(0, document, "Cut drawing");
  record_stroke(shown, document.history(), groups);
  EXPECT_EQ(shown.stroke->removed_area, area);
  EXPECT_EQ(shown.stroke->statistics.faces_made, faces);
}

TEST(StepGroups, no_stroke_is_the_last_cut_after_a_knife_until_that_is_undone) {
  Document document = sphere_document();
  drill(document, 0.5);
  ShownStatistics shown;
  ASSERT_TRUE(document.apply(CutPlane{{{1, 0, 0}, 0}}).ok());
  record_stroke(shown, document.history(), StepGroups());
  EXPECT_FALSE(shown.stroke);
  EXPECT_TRUE(shown.cut_by_knife);
  ASSERT_TRUE(document.apply(Undo{}).ok());
  record_stroke(shown, document.history(), StepGroups());
  EXPECT_TRUE(shown.stroke);
  EXPECT_FALSE(shown.cut_by_knife);
}

}  // namespace
}  // namespace kerf
