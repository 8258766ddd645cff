#include "ui/editor/shell/catalogue.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "tests/support/editor_features.h"
#include "ui/editor/shell/dialogs.h"

namespace kerf {
namespace {

class BindingsTest : public testing::Test {
 protected:
  test::EditorFeatures editor;
  Workspace& workspace = editor.workspace;
  const std::vector<UserAction>& usual = editor.catalogue.usual;

  const UserAction& action(const std::vector<UserAction>& of, const std::string& id) const {
    for (const UserAction& a : of) {
      if (a.id == id) return a;
    }
    ADD_FAILURE() << id;
    return of.front();
  }
  void expect_no_clash(const std::vector<UserAction>& actions) const {
    for (const UserAction& a : actions) {
      const UserAction* other = clash_of(actions, a, {a.key, a.mods});
      EXPECT_EQ(other, nullptr) << a.name << " and " << other->name;
    }
  }
};

TEST_F(BindingsTest, shortcut_text_matches_the_key_and_parses_back) {
  for (const UserAction& a : usual) {
    EXPECT_EQ(chord_text({a.key, a.mods}), a.shortcut) << a.name;
    if (a.shortcut.empty()) continue;
    EXPECT_EQ(parse_chord(a.shortcut), (KeyChord{a.key, a.mods})) << a.name;
  }
}

TEST_F(BindingsTest, every_named_key_parses_back) {
  for (int key = 0; key <= GLFW_KEY_LAST; ++key) {
    for (const int mods : {0, GLFW_MOD_CONTROL, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT}) {
      const std::string text = chord_text({key, mods});
      if (text.empty()) continue;
      EXPECT_EQ(parse_chord(text), (KeyChord{key, mods})) << text;
    }
  }
  for (const char* wrong : {"", "Ctrl+", "Ctr+Z", "Shift+Ctrl+Z", "F99", "z", "Ctrl"})
    EXPECT_FALSE(parse_chord(wrong)) << wrong;
}

TEST_F(BindingsTest, presets_use_valid_actions_without_conflicts) {
  for (const BindingPreset& preset : binding_presets()) {
    SCOPED_TRACE(preset.name);
    for (const auto& [id, key] : preset.bindings) {
      EXPECT_EQ(action(usual, id).id, id);
      EXPECT_TRUE(key.empty() || parse_chord(key)) << key;
    }
    expect_no_clash(bind_keys(usual, preset.bindings));
  }
}

TEST_F(BindingsTest, a_key_is_taken_from_its_previous_action_and_defaults_are_not_stored) {
  Bindings bindings;
  rebind(bindings, usual, "view.wire", {'B', 0});
  const std::vector<UserAction> bound = bind_keys(usual, bindings);
  EXPECT_EQ(action(bound, "view.wire").shortcut, "B");
  EXPECT_EQ(action(bound, "view.boxes").key, 0);
  expect_no_clash(bound);
  EXPECT_EQ(bindings.size(), 2u);
  rebind(bindings, usual, "view.wire", {'W', 0});
  rebind(bindings, usual, "view.boxes", {'B', 0});
  EXPECT_TRUE(bindings.empty());
}

TEST_F(BindingsTest, an_alternative_is_taken_without_the_key_and_stays_taken) {
  const KeyChord key = *parse_chord("Ctrl+Shift+Z"), alternative = *parse_chord("Ctrl+Y");
  ASSERT_EQ(action(usual, "edit.redo").shortcut, "Ctrl+Shift+Z");
  ASSERT_EQ(action(usual, "edit.redo").also, alternative);
  Bindings bindings;
  rebind(bindings, usual, "view.wire", alternative);
  for (int i = 0; i < 2; ++i) {
    const std::vector<UserAction> bound = bind_keys(usual, bindings);
    EXPECT_EQ(action(bound, "view.wire").shortcut, "Ctrl+Y");
    EXPECT_EQ(action(bound, "edit.redo").shortcut, "Ctrl+Shift+Z");
    EXPECT_FALSE(action(bound, "edit.redo").has_key(alternative));
    expect_no_clash(bound);
    rebind(bindings, usual, "edit.redo", key);
  }
  rebind(bindings, usual, "view.wire", {'W', 0});
  EXPECT_TRUE(bindings.empty());
}

TEST_F(BindingsTest, a_context_key_does_not_conflict_with_the_default_one) {
  EXPECT_EQ(clash_of(usual, action(usual, "pieces.move"), {'G', 0}), nullptr);
  const UserAction* other = clash_of(usual, action(usual, "pieces.move"), {'R', 0});
  ASSERT_NE(other, nullptr);
  EXPECT_EQ(other->id, "pieces.rotate");
}

TEST_F(BindingsTest, invalid_settings_change_nothing) {
  const std::vector<UserAction> bound = bind_keys(usual, {{"No such action", "A"}, {"view.wire", "Hyper+W"}});
  for (size_t i = 0; i < usual.size(); ++i) EXPECT_EQ(bound[i].shortcut, usual[i].shortcut);
}

TEST_F(BindingsTest, the_page_reports_a_conflict_before_it_assigns_a_key) {
  SettingsPage page{.shown = true, .waits_for = "view.wire"};
  Settings settings;
  const auto press = [&](int key, int mods = 0) { settings_page_key(page, settings, usual, key, mods); };
  press(GLFW_KEY_LEFT_CONTROL, GLFW_MOD_CONTROL);
  EXPECT_FALSE(page.clashes);
  press('B');
  EXPECT_EQ(page.clashes, (KeyChord{'B', 0}));
  EXPECT_TRUE(settings.bindings.empty());
  press(GLFW_KEY_ESCAPE);
  EXPECT_TRUE(page.shown && settings.bindings.empty() && page.waits_for.empty());
  page.waits_for = "view.wire";
  press('B');
  press(GLFW_KEY_ENTER);
  EXPECT_EQ(settings.bindings.at("view.wire"), "B");
  EXPECT_EQ(settings.bindings.at("view.boxes"), "");
  press(GLFW_KEY_ESCAPE);
  EXPECT_FALSE(page.shown);
}

}  // namespace
}  // namespace kerf
