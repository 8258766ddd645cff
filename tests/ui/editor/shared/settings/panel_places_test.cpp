#include "ui/editor/shared/settings.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

struct Places : ::testing::Test {
  Settings settings;
  PanelPlaces places{settings};

  void add_all() {
    places.add("Laser", Tab::kCut, Dock::kColumn, true);
    places.add("Light", Tab::kLook, Dock::kColumn, true);
    places.add("Graph", Tab::kLook, Dock::kStrip, false);
    places.choose_tab();
  }
};

TEST_F(Places, only_panels_behind_the_front_tab_are_seen) {
  add_all();
  EXPECT_EQ(places.tab(), Tab::kCut);
  EXPECT_TRUE(places.shows("Laser"));
  EXPECT_FALSE(places.shows("Light")) << "unfolded, but behind another tab";
  places.show("Light");
  EXPECT_EQ(places.tab(), Tab::kLook);
  EXPECT_TRUE(places.shows("Light"));
  EXPECT_FALSE(places.shows("Laser"));
}

TEST_F(Places, the_first_tab_is_that_of_the_first_panel_that_is_unfolded) {
  settings.panels = {{"Laser", false}, {"Light", true}};
  add_all();
  EXPECT_EQ(places.tab(), Tab::kLook);
}

TEST_F(Places, a_panel_beside_the_column_is_seen_whatever_the_column_shows) {
  add_all();
  EXPECT_FALSE(places.has_any(Dock::kStrip)) << "folded at first";
  places.show("Graph");
  EXPECT_EQ(places.tab(), Tab::kCut) << "the column stays as it is";
  settings.side_shown = false;
  EXPECT_TRUE(places.shows("Graph"));
  EXPECT_FALSE(places.shows("Laser"));
  EXPECT_TRUE(places.has_any(Dock::kStrip));
  places.fold("Graph");
  EXPECT_FALSE(places.shows("Graph"));
}

TEST_F(Places, docking_shows_a_panel_in_its_new_place) {
  add_all();
  settings.side_shown = false;
  places.dock("Graph", Dock::kColumn);
  EXPECT_TRUE(settings.side_shown);
  EXPECT_EQ(places.tab(), Tab::kLook);
  EXPECT_TRUE(places.shows("Graph"));
  places.dock("Laser", Dock::kWindow);
  EXPECT_TRUE(places.shows("Laser"));
  EXPECT_EQ(places.tab(), Tab::kLook);
}

TEST_F(Places, the_settings_know_a_panel_better_than_its_feature) {
  settings.panels = {{"Laser", false}};
  settings.docks = {{"Graph", Dock::kSecondColumn}};
  add_all();
  EXPECT_FALSE(places.is_unfolded("Laser"));
  EXPECT_EQ(places.dock_of("Graph"), Dock::kSecondColumn);
}

}  // namespace
}  // namespace kerf
