#include "ui/editor/shell/command_palette.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/editor_features.h"
#include "ui/render/view/view_options.h"

namespace kerf {
namespace {

class Palette : public testing::Test {
 protected:
  test::EditorFeatures editor;
  Workspace& workspace = editor.workspace;
  const std::vector<UserAction>& actions = editor.catalogue.usual;
  const std::vector<UserAction> all = nameable_actions(actions);

  std::string best(const char* typed) const {
    const std::vector<size_t> found = find_actions(all, typed);
    return found.empty() ? "" : all[found.front()].name;
  }
};

TEST_F(Palette, finds_an_action_by_parts_of_its_name) {
  EXPECT_EQ(best("undo"), "Undo");
  EXPECT_EQ(best("hide"), "Hide Selected");
  EXPECT_EQ(best("wire"), "Wireframe");
  EXPECT_EQ(best("shvol"), "Shadow Volumes");
  EXPECT_EQ(best("panel light"), "Panels: Light");
  EXPECT_EQ(best("preset noon"), "Light Preset: Noon");
  EXPECT_EQ(best("cull"), "Backface Culling");
  EXPECT_EQ(best("qqqq"), "");
}

TEST_F(Palette, lists_every_action_in_menu_order_for_an_empty_query) {
  const std::vector<size_t> found = find_actions(all, "");
  ASSERT_EQ(found.size(), all.size());
  for (size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], i);
}

TEST_F(Palette, every_action_has_a_unique_name_and_an_effect) {
  std::set<std::string> names;
  for (const UserAction& action : all) {
    EXPECT_TRUE(names.insert(action.name).second) << action.name;
    EXPECT_TRUE(action.run != nullptr) << action.name;
    EXPECT_TRUE(action.items == nullptr) << action.name;
  }
}

TEST_F(Palette, every_view_switch_and_panel_is_found_by_name) {
  for (const ViewSwitch& s : view_switches()) {
    if (s.label[0] == '\0') continue;
    EXPECT_EQ(best(s.label), action_name(s));
  }
  for (const Panel& panel : editor.catalogue.panels)
    EXPECT_EQ(best((std::string("panels ") + panel.title).c_str()), std::string("Panels: ") + panel.title);
}

TEST_F(Palette, panel_actions_change_the_visible_panels) {
  const auto run = [&](const char* typed) { all[find_actions(all, typed).front()].run(); };
  const double before = workspace.laser.radius;
  run("wider beam");
  EXPECT_GT(workspace.laser.radius, before);
  run("refine by depth");
  EXPECT_EQ(workspace.laser.resolution.rule, Resolution::Rule::kDepth);
  const int depth = workspace.laser.resolution.depth;
  run("finer cut");
  EXPECT_EQ(workspace.laser.resolution.depth, depth + 1);
  run("add light");
  EXPECT_EQ(workspace.view.look.lights.size(), 2u);
  run("remove light");
  EXPECT_EQ(workspace.view.look.lights.size(), 1u);
  const bool shown = workspace.services.panels.shows("tree");
  run("panels tree");
  EXPECT_NE(workspace.services.panels.shows("tree"), shown);
}

}  // namespace
}  // namespace kerf
