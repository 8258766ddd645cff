#include "ui/editor/actions.h"

#include <GLFW/glfw3.h>

#include "ui/editor/file_choice.h"
#include "ui/editor/frame/file_menus.h"
#include "ui/editor/key_modifiers.h"
#include "ui/editor/view/piece_set.h"

namespace kerf {

namespace {

void save(EditorState& state) {
  if (state.work.file.empty()) return choose_file_for(state, FileBrowser::Purpose::kSave);
  state.requests.save_to = state.work.file;
}

}  // namespace

std::vector<UserAction> open_actions(EditorState& s) {
  return {
      UserAction{.menu = "File",
                 .name = "New",
                 .shortcut = "Ctrl+N",
                 .key = GLFW_KEY_N,
                 .mods = kCtrl,
                 .tip = "The first scene again, uncut.",
                 .run = [&s] { s.requests.fresh = true; }},
      UserAction{.menu = "File",
                 .name = "Open...",
                 .shortcut = "Ctrl+O",
                 .key = GLFW_KEY_O,
                 .mods = kCtrl,
                 .tip =
                     "A scene (.json), a journal (.kerf) or a mesh (.obj .stl .ply .off). Files can also be "
                     "dropped on "
                     "the window.",
                 .run = [&s] { choose_file_for(s, FileBrowser::Purpose::kOpen); }},
      UserAction{.menu = "File",
                 .name = "Open recent",
                 .items = [&s] { return recent_actions(s.settings, s.requests); }},
      UserAction{.menu = "File",
                 .name = "Examples",
                 .items = [&s] { return example_actions(s.requests); },
                 .ends_group = true},
  };
}

std::vector<UserAction> save_actions(EditorState& s) {
  return {
      UserAction{
          .menu = "File",
          .name = "Save",
          .shortcut = "Ctrl+S",
          .key = GLFW_KEY_S,
          .mods = kCtrl,
          .tip = "Everything that was done, as a journal (.kerf). The version before is kept as .kerf~.",
          .run = [&s] { save(s); }},
      UserAction{.menu = "File",
                 .name = "Save as...",
                 .shortcut = "Ctrl+Shift+S",
                 .key = GLFW_KEY_S,
                 .mods = kCtrl | kShift,
                 .tip = "To another journal (.kerf), or as a scene (.json) without what was cut.",
                 .run = [&s] { choose_file_for(s, FileBrowser::Purpose::kSave); },
                 .ends_group = true},
  };
}

std::vector<UserAction> output_actions(EditorState& s) {
  return {
      UserAction{.menu = "File",
                 .name = "Export chosen pieces...",
                 .shortcut = "Ctrl+E",
                 .key = GLFW_KEY_E,
                 .mods = kCtrl,
                 .tip = "As meshes, where they stand; several go to numbered files.",
                 .run = [&s] { choose_file_for(s, FileBrowser::Purpose::kExport); },
                 .why_not = [&s] { return why_none_chosen(s.view.look.pieces); }},
      UserAction{.menu = "File",
                 .name = "Save the picture",
                 .shortcut = "F12",
                 .key = GLFW_KEY_F12,
                 .tip = "A PNG of the picture without panels, named by date, in the current folder.",
                 .run = [&s] { s.requests.screenshot = Requests::Screenshot::kPicture; }},
      UserAction{.menu = "File",
                 .name = "Save the window",
                 .shortcut = "Shift+F12",
                 .key = GLFW_KEY_F12,
                 .mods = kShift,
                 .tip = "A PNG of the window with its panels.",
                 .run = [&s] { s.requests.screenshot = Requests::Screenshot::kWindow; },
                 .ends_group = true},
      UserAction{.menu = "File",
                 .name = "Play the game",
                 .shortcut = "F5",
                 .key = GLFW_KEY_F5,
                 .tip = "A car with a laser on its roof against others. What is open here stays as it is.",
                 .run = [&s] { s.requests.play = true; },
                 .ends_group = true},
      UserAction{.menu = "File",
                 .name = "Quit",
                 .shortcut = "Ctrl+Q",
                 .key = GLFW_KEY_Q,
                 .mods = kCtrl,
                 .tip = "Ends the editor. The settings are kept.",
                 .run = [&s] { s.requests.quit = true; }},
  };
}

}  // namespace kerf
