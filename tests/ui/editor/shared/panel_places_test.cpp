#include "ui/editor/shared/settings.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

struct PanelPlacesTest : ::testing::Test {
  Settings settings;
  PanelPlaces places{settings};

  void add_all() {
    places.add("laser", Tab::kCut, Dock::kColumn, true);
    places.add("light", Tab::kView, Dock::kColumn, true);
    places.add("graph", Tab::kView, Dock::kStrip, false);
    places.select_tab();
  }
};

TEST_F(PanelPlacesTest, only_panels_of_the_front_tab_are_visible) {
  add_all();
  EXPECT_EQ(places.tab(), Tab::kCut);
  EXPECT_TRUE(places.shows("laser"));
  EXPECT_FALSE(places.shows("light")) << "unfolded, but behind another tab";
  places.show("light");
  EXPECT_EQ(places.tab(), Tab::kView);
  EXPECT_TRUE(places.shows("light"));
  EXPECT_FALSE(places.shows("laser"));
}

TEST_F(PanelPlacesTest, the_initial_tab_is_that_of_the_first_unfolded_panel) {
  settings.panels = {{"laser", false}, {"light", true}};
  add_all();
  EXPECT_EQ(places.tab(), Tab::kView);
}

TEST_F(PanelPlacesTest, a_panel_outside_the_sidebar_is_visible_with_any_tab) {
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

TEST_F(PanelPlacesTest, docking_reveals_a_panel_at_its_new_place) {
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

TEST_F(PanelPlacesTest, settings_override_the_defaults_of_a_feature) {
  settings.panels = {{"laser", false}};
  settings.docks = {{"graph", Dock::kSecondColumn}};
  add_all();
  EXPECT_FALSE(places.is_unfolded("laser"));
  EXPECT_EQ(places.dock_of("graph"), Dock::kSecondColumn);
}

}  // namespace
}  // namespace kerf
