#include "ui/editor/shared/settings.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

struct Places : ::testing::Test {
  Settings settings;
  PanelPlaces places{settings};

  void add_all() {
    places.add("laser", Tab::kCut, Dock::kColumn, true);
    places.add("light", Tab::kView, Dock::kColumn, true);
    places.add("graph", Tab::kView, Dock::kStrip, false);
    places.select_tab();
  }
};

TEST_F(Places, only_panels_behind_the_front_tab_are_seen) {
  add_all();
  EXPECT_EQ(places.tab(), Tab::kCut);
  EXPECT_TRUE(places.shows("laser"));
  EXPECT_FALSE(places.shows("light")) << "unfolded, but behind another tab";
  places.show("light");
  EXPECT_EQ(places.tab(), Tab::kView);
  EXPECT_TRUE(places.shows("light"));
  EXPECT_FALSE(places.shows("laser"));
}

TEST_F(Places, the_first_tab_is_that_of_the_first_panel_that_is_unfolded) {
  settings.panels = {{"laser", false}, {"light", true}};
  add_all();
  EXPECT_EQ(places.tab(), Tab::kView);
}

TEST_F(Places, a_panel_beside_the_column_is_seen_whatever_the_column_shows) {
  add_all();
  EXPECT_FALSE(places.has_any(Dock::kStrip)) << "folded at first";
  places.show("graph");
  EXPECT_EQ(places.tab(), Tab::kCut) << "the column stays as it is";
  settings.side_shown = false;
  EXPECT_TRUE(places.shows("graph"));
  EXPECT_FALSE(places.shows("laser"));
  EXPECT_TRUE(places.has_any(Dock::kStrip));
  places.fold("graph");
  EXPECT_FALSE(places.shows("graph"));
}

TEST_F(Places, docking_shows_a_panel_in_its_new_place) {
  add_all();
  settings.side_shown = false;
  places.dock("graph", Dock::kColumn);
  EXPECT_TRUE(settings.side_shown);
  EXPECT_EQ(places.tab(), Tab::kView);
  EXPECT_TRUE(places.shows("graph"));
  places.dock("laser", Dock::kWindow);
  EXPECT_TRUE(places.shows("laser"));
  EXPECT_EQ(places.tab(), Tab::kView);
}

TEST_F(Places, the_settings_know_a_panel_better_than_its_feature) {
  settings.panels = {{"laser", false}};
  settings.docks = {{"graph", Dock::kSecondColumn}};
  add_all();
  EXPECT_FALSE(places.is_unfolded("laser"));
  EXPECT_EQ(places.dock_of("graph"), Dock::kSecondColumn);
}

}  // namespace
}  // namespace kerf
