#include "ui/editor/shell/dialogs.h"

#include <imgui.h>

#include "ui/editor/shell/command_palette.h"
#include "ui/editor/shell/message_log.h"
#include "ui/editor/shell/panel_column.h"
#include "ui/editor/shell/settings_page.h"
#include "ui/editor/shell/shortcut_sheet.h"
#include "ui/editor/shell/tab_bar.h"
#include "ui/window/gui_input.h"

namespace kerf {

namespace {

class Dialogs : public Feature {
 public:
  Dialogs(Workspace& on, const Catalogue& catalogue) : on_(on), catalogue_(catalogue) {}

  std::vector<ActionGroup> actions() override {
    return {{721, "View", column_actions()}, {800, "Help", help_actions()}};
  }
  std::vector<Gesture> gestures() const override {
    return {{100, "Middle drag, Alt+left drag", "Orbit"},
            {110, "Shift+middle drag, right drag", "Pan"},
            {140, "Wheel", "Zoom to the pointer"},
            {160, "Esc",
             "Close a menu; end the cut, also one that is still at work; stop opening a file; let go of the "
             "chosen pieces"}};
  }

  bool takes(const InputEvent& event, bool) override;
  bool let_go() override {
    const bool shown = shortcuts_shown_ || on_.messages_shown;
    shortcuts_shown_ = on_.messages_shown = false;
    return shown;
  }
  bool awaits_focus() const override { return on_.browser.open || palette_.open; }
  void draw_windows() override;
  void mark(Landmarks& landmarks) const override {
    if (on_.browser.open) landmarks.mark("browser", {on_.pointer, Vec2(1)});
  }

 private:
  std::vector<UserAction> column_actions();
  std::vector<UserAction> help_actions();

  Workspace& on_;
  const Catalogue& catalogue_;
  CommandPalette palette_;
  SettingsPage page_;
  bool shortcuts_shown_ = false;
};

std::vector<UserAction> Dialogs::column_actions() {
  bool& shown = on_.settings.side_shown;
  std::vector<UserAction> actions = tab_actions(on_.panels);
  actions.push_back(
      {.name = "Panels", .items = [this] { return panel_actions(catalogue_.panels, on_.panels); }});
  actions.push_back({.name = "Column of panels",
                     .shortcut = "F4",
                     .tip = "Hides the column, so that the picture fills the window.",
                     .run = [&shown] { shown = !shown; },
                     .checked = [&shown] { return shown; }});
  return actions;
}

std::vector<UserAction> Dialogs::help_actions() {
  return {
      UserAction{.name = "Command palette",
                 .shortcut = "Ctrl+P",
                 .tip = "Finds any action by parts of its name, and shows its key.",
                 .run = [this] { open_palette(palette_); }},
      UserAction{.name = "Settings",
                 .shortcut = "Ctrl+,",
                 .tip = "The speed of the mouse, and the keys of all actions.",
                 .run = [this] { page_.shown = !page_.shown; },
                 .checked = [this] { return page_.shown; }},
      UserAction{.name = "Shortcuts",
                 .shortcut = "F1",
                 .tip = "All keys, and what the mouse does.",
                 .run = [this] { shortcuts_shown_ = !shortcuts_shown_; },
                 .checked = [this] { return shortcuts_shown_; }},
      UserAction{.name = "Messages",
                 .tip = "What the status bar has said, in full. A click on its message shows them too.",
                 .run = [this] { on_.messages_shown = !on_.messages_shown; },
                 .checked = [this] { return on_.messages_shown; }},
  };
}

bool Dialogs::takes(const InputEvent& event, bool) {
  if (event.kind != InputEvent::Kind::kKey) return false;
  if (on_.browser.open) {
    browser_key(on_.browser, event.button);
  } else if (palette_.open) {
    palette_key(palette_, event.button);
  } else if (page_.shown && !is_text_field_active()) {
    settings_page_key(page_, on_.settings, catalogue_.usual, event.button, event.mods);
  } else {
    return false;
  }
  return true;
}

void Dialogs::draw_windows() {
  draw_shortcut_sheet(shortcuts_shown_, catalogue_.actions, catalogue_.gestures);
  draw_message_log(on_.messages_shown, on_.message);
  draw_settings_page(page_, on_.settings, catalogue_.usual);
  const Area& picture = on_.view.layout.viewport;
  draw_palette(palette_, catalogue_.actions, static_cast<float>(picture.at.x + 0.5 * picture.size.x),
               static_cast<float>(picture.at.y + ImGui::GetFontSize()));
  const bool was_open = on_.browser.open;
  draw_file_browser(on_.browser);
  if (was_open && !on_.browser.open) on_.settings.folder = on_.browser.folder;
}

}  // namespace

std::unique_ptr<Feature> dialogs(Workspace& on, const Catalogue& catalogue) {
  return std::make_unique<Dialogs>(on, catalogue);
}

}  // namespace kerf
