#include "ui/editor/key_modifiers.h"
#include "ui/editor/laser_desk.h"

#include <GLFW/glfw3.h>

#include "ui/editor/actions.h"
#include "ui/editor/file_choice.h"

namespace kerf {

namespace {

constexpr const char* kEmpty = "The path has no points.";

// The keys of undo and redo belong to the path while it is in hand, until it is run.
bool takes_undo(const EditorState& s) {
  return s.hand.tool == Tool::kPath && s.lasers.path.is_newer_than(s.work.document.history().position());
}

UserAction undo_action(EditorState& s) {
  return {.menu = "Path",
          .name = "Undo the edit of the path",
          .shortcut = "Ctrl+Z",
          .key = GLFW_KEY_Z,
          .mods = kCtrl,
          .tip = "The key does it with the path in hand, until the path is run.",
          .run = [&s] { s.lasers.path.undo(); },
          .why_not = [&s] { return s.lasers.path.can_undo() ? nullptr : "The path was not edited yet."; },
          .has_key_when = [&s] { return takes_undo(s) && s.lasers.path.can_undo(); }};
}

UserAction redo_action(EditorState& s) {
  return {.menu = "Path",
          .name = "Redo the edit of the path",
          .shortcut = "Ctrl+Shift+Z",
          .key = GLFW_KEY_Z,
          .mods = kCtrl | kShift,
          .tip = "Edits the path again as before the undo.",
          .run = [&s] { s.lasers.path.redo(); },
          .why_not = [&s] { return s.lasers.path.can_redo() ? nullptr : "No edit of the path was undone."; },
          .has_key_when = [&s] { return takes_undo(s) && s.lasers.path.can_redo(); },
          .ends_group = true};
}

UserAction remove_action(EditorState& s) {
  return {.menu = "Path",
          .name = "Remove the point",
          .shortcut = "Del",
          .key = GLFW_KEY_DELETE,
          .pad_key = GLFW_KEY_BACKSPACE,
          .tip = "The chosen point of the path; Backspace does the same.",
          .run =
              [&s] {
                s.lasers.path.begin_edit();
                s.lasers.path.remove(*s.lasers.path.chosen());
              },
          .why_not = [&s] { return s.lasers.path.chosen() ? nullptr : "No point of the path is chosen."; },
          .has_key_when = [&s] { return s.hand.tool == Tool::kPath && s.lasers.path.chosen(); },
          .ends_group = true};
}

UserAction clear_action(EditorState& s) {
  return {.menu = "Path",
          .name = "Clear the path",
          .tip = "Removes all points.",
          .run =
              [&s] {
                s.lasers.path.begin_edit();
                s.lasers.path.clear();
              },
          .why_not = [&s] { return s.lasers.path.empty() ? kEmpty : nullptr; }};
}

}  // namespace

std::vector<UserAction> path_actions(EditorState& s) {
  return {
      UserAction{.menu = "Path",
                 .name = "Run the path",
                 .shortcut = "Ctrl+Enter",
                 .key = GLFW_KEY_ENTER,
                 .mods = kCtrl,
                 .pad_key = GLFW_KEY_KP_ENTER,
                 .tip = "Cuts along the path, as kerf cut --path does with its file.",
                 .run = [&s] { s.requests.run_path = true; },
                 .why_not = [&s] { return why_no_run(s); },
                 .ends_group = true},
      UserAction{.menu = "Path",
                 .name = "Load a path...",
                 .tip = "A path file (.json). It can also be dropped on the window.",
                 .run = [&s] { choose_file_for(s, FileBrowser::Purpose::kOpenPath); }},
      UserAction{.menu = "Path",
                 .name = "Save the path...",
                 .tip = "As a file (.json) for kerf cut --path.",
                 .run = [&s] { choose_file_for(s, FileBrowser::Purpose::kSavePath); },
                 .why_not = [&s] { return s.lasers.path.empty() ? kEmpty : nullptr; }},
      clear_action(s),
      remove_action(s),
      undo_action(s),
      redo_action(s),
  };
}

std::vector<UserAction> emitter_actions(EditorState& s) {
  Emitter& emitter = s.lasers.emitter;
  const auto why_none = [&emitter] {
    return emitter.placed() ? nullptr : "There is no emitter: place one first.";
  };
  return {
      UserAction{.menu = "Path",
                 .name = "Place the emitter",
                 .shortcut = "Shift+U",
                 .key = GLFW_KEY_U,
                 .mods = kShift,
                 .tip = "A laser that stands in the scene, aimed at the middle of the picture.",
                 .run = [&s] { place_emitter(s); }},
      UserAction{
          .menu = "Path",
          .name = "Fire the emitter",
          .shortcut = "U",
          .key = GLFW_KEY_U,
          .tip = "Switches it on or off. The Laser panel says whether it fires without a break or in shots.",
          .run = [&emitter] { emitter.firing = !emitter.firing; },
          .checked = [&emitter] { return emitter.firing; },
          .why_not = why_none},
      UserAction{.menu = "Path",
                 .name = "Take the emitter away",
                 .tip = "Takes it out of the scene.",
                 .run = [&emitter] { emitter.remove(); },
                 .why_not = why_none},
  };
}

}  // namespace kerf
