#include "core/base/json.h"
#include "ui/editor/inspect/ruler.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

RulerList two_marks() {
  RulerList list;
  list.begin_edit();
  list.add({0, 0, 0}, {3, 4, 0});
  list.begin_edit();
  list.add({1, 0, 0}, {1, 0, 2});
  return list;
}

TEST(RulerList, each_edit_can_be_undone_and_redone) {
  RulerList list = two_marks();
  list.begin_edit();
  list.rename(0, "height");
  list.begin_edit();
  list.move(0, true, {0, 0, 7});
  const std::vector<RulerMark> all = list.marks();
  EXPECT_EQ(all[0], (RulerMark{"height", {0, 0, 0}, {0, 0, 7}}));
  for (int i = 0; i < 4; ++i) list.undo();
  EXPECT_TRUE(list.marks().empty());
  EXPECT_FALSE(list.can_undo());
  for (int i = 0; i < 4; ++i) list.redo();
  EXPECT_EQ(list.marks(), all);
  EXPECT_FALSE(list.can_redo());
}

TEST(RulerList, a_new_edit_clears_the_redo_history) {
  RulerList list = two_marks();
  list.undo();
  list.begin_edit();
  list.remove(0);
  EXPECT_FALSE(list.can_redo());
  EXPECT_TRUE(list.marks().empty());
}

TEST(RulerList, names_stay_unique_after_a_removal) {
  RulerList list = two_marks();
  list.begin_edit();
  list.remove(0);
  list.begin_edit();
  list.add({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(list.marks()[0].name, "Distance 2");
  EXPECT_EQ(list.marks()[1].name, "Distance 3");
}

TEST(RulerList, finds_the_radius_of_a_circle_that_is_measured) {
  RulerList list = two_marks();
  list.begin_edit();
  list.add({1, 0, 0}, {1, 0, 2}, RulerMark::Circle{{0, 1, 0}, 0.01});
  const RulerMark* known = list.radius_of({1, 0, 1e-9}, 2, {0, -1, 0});
  ASSERT_NE(known, nullptr);
  EXPECT_EQ(known->name, "Radius 3");
  EXPECT_EQ(list.radius_of({1, 0, 0}, 2.1, {0, 1, 0}), nullptr);
  EXPECT_EQ(list.radius_of({1, 0.1, 0}, 2, {0, 1, 0}), nullptr);
  EXPECT_EQ(list.radius_of({1, 0, 0}, 2, {1, 0, 0}), nullptr);
}

TEST(RulerList, round_trips_through_a_document) {
  const RulerList list = two_marks();
  RulerList read;
  read.read(list.to_json());
  EXPECT_EQ(read.marks(), list.marks());
  EXPECT_FALSE(read.can_undo());
  EXPECT_TRUE(RulerList().to_json().is_null());
}

TEST(RulerList, keeps_and_exports_the_circles_of_radii) {
  RulerList list;
  list.begin_edit();
  list.add({1, 2, 3}, {1, 2, 5}, RulerMark::Circle{{0, 1, 0}, 0.25});
  EXPECT_EQ(list.marks()[0].name, "Radius 1");
  RulerList read;
  read.read(list.to_json());
  EXPECT_EQ(read.marks(), list.marks());
  EXPECT_NE(list.to_csv().find("\"Radius 1\",1,2,3,1,2,5,2,radius,0.25\n"), std::string::npos);
  nlohmann::json entry = list.to_json();
  entry[0]["circle"]["normal"] = {0, 0, 0};
  read.read(entry);
  EXPECT_TRUE(read.marks().empty());
}

TEST(RulerList, skips_invalid_entries) {
  RulerList list;
  list.read(nlohmann::json::parse(
      R"([{"name": "a", "from": [0, 0, 0], "to": [1, 0, 0]}, {"name": "b", "from": [0, 0]}, 7])"));
  ASSERT_EQ(list.marks().size(), 1u);
  EXPECT_EQ(list.marks()[0].name, "a");
  list.read(nlohmann::json::parse(R"({"not": "a list"})"));
  EXPECT_TRUE(list.marks().empty());
}

TEST(RulerList, exports_a_table_with_quoted_names) {
  RulerList list = two_marks();
  list.begin_edit();
  list.rename(1, "a \"b\", c");
  EXPECT_EQ(list.to_csv(),
            "name,from x,from y,from z,to x,to y,to z,length,kind,deviation\n"
            "\"Distance 1\",0,0,0,3,4,0,5,distance,\n"
            "\"a \"\"b\"\", c\",1,0,0,1,0,2,2,distance,\n");
}

}  // namespace
}  // namespace kerf
