#include "ui/editor/shell/keymap.h"

#include <gtest/gtest.h>

#include "core/base/json.h"
#include "tests/support/editor_features.h"

namespace kerf {
namespace {

class Keymap : public testing::Test {
 protected:
  Result<Bindings> parse(const std::string& text) const {
    return parse_keymap(text, "my.json", editor.catalogue.usual);
  }
  std::string error_of(const std::string& text) const {
    const auto parsed = parse(text);
    return parsed ? "" : parsed.error().message;
  }

  test::EditorFeatures editor;
};

TEST_F(Keymap, round_trip_of_each_preset_and_of_removed_keys) {
  std::vector<Bindings> all{{{"edit.undo", ""}, {"view.wire", "Ctrl+Shift+F7"}}};
  rebind(all.emplace_back(), editor.catalogue.usual, "view.wire", *parse_chord("Ctrl+Y"));  // also of Redo
  for (const BindingPreset& preset : binding_presets()) all.push_back(preset.bindings);
  for (const Bindings& bindings : all) {
    const auto text = keymap_text(editor.catalogue.usual, bindings);
    ASSERT_TRUE(text);
    const auto parsed = parse(*text);
    ASSERT_TRUE(parsed) << parsed.error().message;
    EXPECT_EQ(*parsed, bindings);
  }
}

TEST_F(Keymap, file_lists_every_action_that_can_have_a_key) {
  const auto text = keymap_text(editor.catalogue.usual, {{"edit.undo", "Alt+U"}});
  ASSERT_TRUE(text);
  const auto keys = nlohmann::json::parse(*text).at("bindings");
  size_t count = 0;
  for (const UserAction& action : editor.catalogue.usual) {
    if (action.items) continue;
    ++count;
    EXPECT_EQ(keys.at(action.id), action.id == "edit.undo" ? "Alt+U" : action.shortcut);
  }
  EXPECT_EQ(keys.size(), count);
}

TEST_F(Keymap, unlisted_actions_keep_their_keys_and_unknown_ones_are_ignored) {
  const auto parsed = parse(
      R"({"keymap": 1, "bindings": {"edit.undo": "Shift+Alt+U", "later.action": "X", "view.wire": "W"}})");
  ASSERT_TRUE(parsed) << parsed.error().message;
  EXPECT_EQ(*parsed, (Bindings{{"edit.undo", chord_text(*parse_chord("Shift+Alt+U"))}}));
}

TEST_F(Keymap, errors_name_the_file_and_the_cause) {
  for (const auto& [text, cause] : std::map<std::string, std::string>{
           {"{", "my.json"},
           {"[]", "not a keymap"},
           {R"({"keymap": 2, "bindings": {}})", "not a keymap"},
           {R"({"keymap": 1})", "bindings"},
           {R"({"keymap": 1, "bindings": {"edit.undo": "Ctrl+Nothing"}})", "Ctrl+Nothing of edit.undo"},
           {R"({"keymap": 1, "bindings": {"edit.undo": 7}})", "7 of edit.undo"},
           {R"({"keymap": 1, "bindings": {"view.wire": "L"}})", "both"}}) {
    EXPECT_NE(error_of(text).find("my.json"), std::string::npos) << text;
    EXPECT_NE(error_of(text).find(cause), std::string::npos) << error_of(text);
  }
}

}  // namespace
}  // namespace kerf
