#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/document/extract.h"
#include "tests/support/checkout.h"
#include "tests/support/editor_features.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/render/view/view_options.h"
#include "ui/window/layout.h"

namespace kerf {
namespace {

class Actions : public testing::Test {
 protected:
  test::EditorFeatures editor;
  Workspace& workspace = editor.workspace;
  const std::vector<UserAction>& actions = editor.catalogue.actions;

  bool handle_key(int key, bool again = false) {
    InputEvent event{InputEvent::Kind::kKey, {}, key};
    event.again = again;
    return std::ranges::any_of(editor.features,
                               [&](const auto& feature) { return feature->handle_event(event, false); });
  }

  // "| Ctrl+O | Open... |" for every row of the sheet that F1 shows, in its order.
  std::vector<std::string> rows_of_sheet() const {
    std::vector<std::string> rows;
    for (const Gesture& g : editor.catalogue.gestures)
      rows.push_back(std::string("| ") + g.gesture + " | " + g.meaning + " |");
    for (const UserAction& a : actions) {
      if (!a.shortcut.empty()) rows.push_back("| " + a.shortcut + " | " + a.name + " |");
    }
    return rows;
  }
};

std::vector<std::string> rows_of_readme() {
  std::ifstream readme(test::checkout() / "ui/editor/README.md");
  std::vector<std::string> rows;
  std::string line;
  while (std::getline(readme, line) && line != "| key or gesture | what it does |") {
  }
  std::getline(readme, line);  // the line under the head
  while (std::getline(readme, line) && line.starts_with("|")) rows.push_back(line);
  return rows;
}

TEST_F(Actions, the_readme_lists_the_same_shortcuts_as_the_sheet) {
  EXPECT_EQ(rows_of_readme(), rows_of_sheet());
}

TEST_F(Actions, have_unique_stable_ids) {
  const std::regex form("[a-z_]+(\\.[a-z0-9_]+)+");
  std::set<std::string> ids;
  for (const UserAction& a : actions) {
    EXPECT_TRUE(std::regex_match(a.id, form)) << a.id << ": " << a.name;
    EXPECT_TRUE(ids.insert(a.id).second) << a.id;
  }
}

TEST_F(Actions, no_two_actions_share_a_key) {
  std::set<std::pair<int, int>> taken;
  for (const UserAction& a : actions) {
    if (a.has_key_when) continue;
    for (const KeyChord& chord : {KeyChord{a.key, a.mods}, a.also})
      EXPECT_TRUE(chord.key == 0 || taken.emplace(chord.key, chord.mods).second) << a.name;
  }
}

TEST_F(Actions, shortcut_text_is_shown_exactly_if_a_key_is_bound) {
  for (const UserAction& a : actions) EXPECT_EQ(!a.shortcut.empty(), a.key != 0) << a.name;
}

TEST_F(Actions, hints_name_the_bound_keys) {
  const auto hint = [&] {
    for (const auto& feature : editor.features) {
      if (const char* words = feature->status_hint()) return std::string(words);
    }
    return std::string();
  };
  for (const auto& [tool, action] :
       {std::pair(kLaserTool, "help.shortcuts"), std::pair(kPathTool, "path.run")}) {
    workspace.input.tool = tool;
    workspace.view.shortcuts = {{action, "Alt+9"}};
    EXPECT_NE(hint().find("Alt+9"), std::string::npos) << hint();
    workspace.view.shortcuts.clear();
    EXPECT_TRUE(hint().find("F1") == std::string::npos && hint().find("Ctrl+Enter") == std::string::npos)
        << hint();
  }
}

TEST_F(Actions, either_run_or_open_a_menu) {
  for (const UserAction& a : actions) EXPECT_TRUE((a.run != nullptr) != (a.items != nullptr)) << a.name;
}

TEST_F(Actions, every_menu_action_has_a_tooltip) {
  for (const UserAction& a : actions) {
    EXPECT_TRUE(a.items != nullptr || !a.tip.empty()) << a.name;
  }
}

TEST_F(Actions, a_key_toggles_a_view_switch_and_a_disabled_action_reports_why) {
  for (const ViewSwitch& s : view_switches()) {
    if (s.key == 0) continue;
    const size_t before = s.get(workspace.view.look);
    EXPECT_TRUE(run_shortcut(actions, s.key, 0, workspace.message)) << s.label;
    EXPECT_NE(s.get(workspace.view.look), before) << s.label;
  }
  EXPECT_FALSE(workspace.message.is_error);
  EXPECT_TRUE(run_shortcut(actions, 'H', 0, workspace.message));
  EXPECT_TRUE(workspace.message.is_error);
  EXPECT_FALSE(run_shortcut(actions, GLFW_KEY_F7, 0, workspace.message));
  EXPECT_TRUE(workspace.message.is_error);
  EXPECT_TRUE(run_shortcut(actions, 'W', 0, workspace.message));
  EXPECT_EQ(workspace.message.text, "") << "the reason holds until the next action";
}

TEST_F(Actions, alternative_keys_run_the_same_action) {
  World world;
  world.add(make_body("left", test::build(test::sphere(8, 12, 1))));
  world.add(make_body("right", test::build(test::sphere(8, 12, 2))));
  workspace.session.document = Document(std::move(world));
  PieceMap& looks = workspace.view.look.pieces;
  for (const int mods : {0, GLFW_MOD_CONTROL}) {
    EXPECT_TRUE(run_shortcut(actions, 'A', mods, workspace.message));
    EXPECT_EQ(selected_count(looks), 2u);
    deselect_all(looks);
  }
  select_piece(looks, {workspace.world().ids().front(), 0}, false);
  EXPECT_TRUE(run_shortcut(actions, 'I', GLFW_MOD_CONTROL, workspace.message));
  EXPECT_EQ(first_selected(looks), PieceId(workspace.world().ids().back(), 0));
  find_action(actions, "pieces.select_similar")->run();
  EXPECT_EQ(selected_count(looks), 1u);  // the area of the other sphere is a fourth
}

TEST_F(Actions, framing_fits_the_pieces_where_an_exploded_view_shows_them) {
  World world;
  for (const double x : {-1, 1}) {
    Body ball = make_body("ball", test::build(test::sphere(8, 12, 1)));
    ball.placement.position.x = x;
    world.add(std::move(ball));
  }
  workspace.session.document = Document(std::move(world));
  ViewState& view = workspace.view;
  view.layout = lay_out({1000, 700}, 16, 26, 26);
  const auto distance = [&](const std::string& action, double spread) {
    spread_pieces(workspace.world(), spread, view.look);
    find_action(actions, action)->run();
    view.camera.finish();
    return glm::length(view.seen_first().eye - view.camera.pivot());
  };
  for (const char* action : {"view.frame_all", "view.frame_selected"})
    EXPECT_GT(distance(action, 1.5), 1.2 * distance(action, 0)) << action;
}

TEST_F(Actions, paste_needs_a_copied_piece_that_exists) {
  World world;
  world.add(make_body("left", test::build(test::sphere(8, 12, 1))));
  world.add(make_body("right", test::build(test::sphere(8, 12, 2))));
  workspace.session.document = Document(std::move(world));
  const PieceId left{workspace.world().ids().front(), 0};
  select_piece(workspace.view.look.pieces, left, false);
  find_action(actions, "pieces.copy")->run();
  const UserAction& paste = *find_action(actions, "pieces.paste");
  EXPECT_EQ(paste.objection(), nullptr);
  workspace.session.document.apply(DeletePiece{left});
  EXPECT_NE(paste.objection(), nullptr);
}

TEST_F(Actions, paste_adds_no_other_piece_that_has_the_label_of_an_undone_one) {
  World world;
  world.add(make_body("plate", test::build(test::grid(16, 1))));
  Document& document = workspace.session.document = Document(std::move(world));
  const auto cut = [&](double x) {
    CutSettings settings;
    settings.laser.radius = 0.01;
    settings.laser.range = {0, 5};
    settings.resolution.target_edge = 0.005;
    document.apply(BeginStroke{settings, {{x, 1, -0.7}, {0, -1, 0}}});
    document.apply(MoveBeam{{{x, 1, 0.7}, {0, -1, 0}}});
    document.apply(EndStroke{});
    while (document.waiting() > 0) ASSERT_TRUE(document.step(64).ok());
  };
  const PieceId piece{workspace.world().ids().front(), 1};
  const UserAction& paste = *find_action(actions, "pieces.paste");
  cut(-0.3);
  ASSERT_TRUE(has_faces(workspace.world(), piece));
  select_piece(workspace.view.look.pieces, piece, false);
  find_action(actions, "pieces.copy")->run();
  EXPECT_EQ(paste.objection(), nullptr);
  const Outcome undone = document.apply(Undo{});
  for (const auto& feature : editor.features) feature->on_world_changed(undone.delta);
  EXPECT_NE(paste.objection(), nullptr);
  cut(0.3);
  ASSERT_TRUE(has_faces(workspace.world(), piece));
  EXPECT_NE(paste.objection(), nullptr);
}

TEST_F(Actions, the_game_begins_without_a_beam_that_stays_on) {
  World world;
  world.add(make_body("ball", test::build(test::sphere(8, 12, 1))));
  workspace.session.document = Document(std::move(world));
  workspace.beam.fire(workspace.session.document, {{0, 0, 5}, {0, 0, -1}}, 4, {}, 0);
  workspace.input.held = std::make_unique<PlainDrag>("Cutting", [](const InputEvent&) {});
  find_action(actions, "file.play_game")->run();
  EXPECT_EQ(workspace.links.leaves, Leaves::kForTheGame);
  EXPECT_FALSE(workspace.beam.cutting());
  EXPECT_EQ(workspace.input.held, nullptr);
}

TEST_F(Actions, a_file_dialog_is_cancelled_before_the_question_about_unsaved_changes) {
  World world;
  world.add(make_body("ball", test::build(test::sphere(8, 12, 1))));
  workspace.session.document = Document(std::move(world));
  workspace.session.document.apply(DeletePiece{{workspace.world().ids().front(), 0}});
  const auto asks = [this] {
    return editor.features.front()->handle_event({InputEvent::Kind::kKey, {}, GLFW_KEY_7}, false);
  };
  workspace.services.browser.open = true;
  workspace.links.quit();
  workspace.changes.process_requests();
  EXPECT_TRUE(workspace.services.browser.keys.escape);
  EXPECT_FALSE(asks());
  workspace.services.browser.open = false;
  workspace.changes.process_requests();
  EXPECT_TRUE(asks());
  EXPECT_EQ(workspace.links.leaves, Leaves::kNot);
}

TEST_F(Actions, a_held_enter_key_does_not_confirm_the_replacement_of_a_file) {
  FileBrowser& browser = workspace.services.browser;
  browser.open = true;
  EXPECT_TRUE(handle_key(GLFW_KEY_ENTER, true));
  EXPECT_FALSE(browser.keys.enter);
  EXPECT_TRUE(handle_key(GLFW_KEY_DOWN, true));
  EXPECT_EQ(browser.keys.steps, 1);
  EXPECT_TRUE(handle_key(GLFW_KEY_ENTER));
  EXPECT_TRUE(browser.keys.enter);
}

TEST_F(Actions, a_held_key_is_not_bound_in_the_settings) {
  ImGui::CreateContext();
  find_action(actions, "help.settings")->run();
  for (const int key : {GLFW_KEY_PAGE_DOWN, GLFW_KEY_PAGE_DOWN, GLFW_KEY_PAGE_DOWN, GLFW_KEY_PAGE_DOWN,
                        GLFW_KEY_DOWN, GLFW_KEY_DOWN, GLFW_KEY_ENTER})
    EXPECT_TRUE(handle_key(key));
  EXPECT_TRUE(handle_key(GLFW_KEY_ENTER, true));
  EXPECT_TRUE(workspace.settings.bindings.empty());
  EXPECT_TRUE(handle_key(GLFW_KEY_F7));
  EXPECT_EQ(workspace.settings.bindings.size(), 1u);
  ImGui::DestroyContext();
}

TEST_F(Actions, volumes_and_counts_of_shadows_exclude_each_other_and_all_can_be_reset) {
  ShowOptions& show = workspace.view.look.show;
  run_shortcut(actions, 'V', 0, workspace.message);
  run_shortcut(actions, 'C', 0, workspace.message);
  EXPECT_TRUE(show.shadow_stencil && !show.shadow_volumes);
  run_shortcut(actions, 'V', 0, workspace.message);
  EXPECT_TRUE(!show.shadow_stencil && show.shadow_volumes);
  run_shortcut(actions, 'W', 0, workspace.message);
  find_action(actions, "view.reset_overlays")->run();
  EXPECT_EQ(show, default_show());
}

TEST_F(Actions, change_the_levels_of_the_tree_within_its_depth) {
  TreeOverlay& tree = workspace.view.look.tree;
  workspace.view.look.show.aabb = true;
  workspace.services.statistics.shown.tree = TreeStatistics{.levels = std::vector<TreeLevel>(6)};
  tree.one_level = true;
  tree.deepest = 5;
  find_action(actions, "tree.level_more")->run();
  EXPECT_EQ(tree.deepest, 5);
  find_action(actions, "tree.level_less")->run();
  EXPECT_EQ(tree.deepest, 4);
  workspace.services.statistics.shown.tree.reset();
  find_action(actions, "tree.level_less")->run();
  EXPECT_EQ(tree.deepest, 4) << "the depth of the tree is unknown";
}

TEST(FeatureLinks, separate_the_files_of_features_from_those_to_open) {
  const test::EditorFeatures editor;
  std::vector<std::filesystem::path> files{"part.obj", "lines.svg", "car.json", "lines.dxf"};
  const std::vector<std::filesystem::path> drawings{"lines.svg", "lines.dxf"}, opened{"part.obj", "car.json"};
  EXPECT_EQ(editor.workspace.links.extract_accepted(files), drawings);
  EXPECT_EQ(files, opened);
}

class LayoutTable : public testing::Test {
 protected:
  using Ids = std::multiset<std::string>;

  static Ids ids_of(std::span<const MenuLayout> menus) {
    Ids ids;
    for (const MenuLayout& menu : menus) ids.insert(menu.actions.begin(), menu.actions.end());
    ids.erase(MenuLayout::kLine);
    std::erase_if(ids, [](const std::string& id) { return id.front() == MenuLayout::kSubmenu; });
    return ids;
  }
  template <typename List>
  Ids provided(const std::function<List(Feature&)>& list_of) const {
    Ids ids;
    for (const auto& feature : editor.features) {
      for (const auto& one : list_of(*feature)) ids.insert(one.id);
    }
    return ids;
  }

  test::EditorFeatures editor;
};

TEST_F(LayoutTable, lists_each_action_exactly_once) {
  Ids named = ids_of(menu_layout());
  named.merge(ids_of(palette_layout()));
  EXPECT_EQ(named, provided<std::vector<UserAction>>(&Feature::actions));
}

TEST_F(LayoutTable, context_menus_consist_of_actions) {
  const Ids known = provided<std::vector<UserAction>>(&Feature::actions);
  for (const bool over_piece : {false, true}) {
    for (const std::string id : context_layout(over_piece))
      EXPECT_TRUE(id == MenuLayout::kLine || known.contains(id)) << id;
  }
}

TEST_F(LayoutTable, lists_each_part_of_a_panel_exactly_once) {
  Ids named;
  std::set<std::string> panels;
  for (const TabLayout& tab : tab_layout()) {
    for (const PanelLayout& panel : tab.panels) {
      EXPECT_TRUE(panels.insert(panel.id).second) << panel.id;
      named.insert(panel.parts.begin(), panel.parts.end());
    }
  }
  EXPECT_EQ(named, provided<std::vector<PanelPart>>(&Feature::panel_parts));
}

TEST_F(LayoutTable, lists_each_gesture_exactly_once) {
  EXPECT_EQ(Ids(gesture_layout().begin(), gesture_layout().end()),
            provided<std::vector<Gesture>>(&Feature::gestures));
}

TEST_F(LayoutTable, has_separators_only_between_actions) {
  for (const MenuLayout& menu : menu_layout()) {
    EXPECT_STRNE(menu.actions.front(), MenuLayout::kLine) << menu.title;
    EXPECT_STRNE(menu.actions.back(), MenuLayout::kLine) << menu.title;
    for (size_t i = 1; i < menu.actions.size(); ++i)
      EXPECT_STRNE(menu.actions[i - 1], menu.actions[i]) << menu.title;
  }
}

}  // namespace
}  // namespace kerf
