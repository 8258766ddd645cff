#include "ui/editor/actions.h"

#include <imgui.h>

#include <GLFW/glfw3.h>

#include "core/base/assert.h"
#include "ui/editor/changes/world_changes.h"
#include "ui/editor/key_modifiers.h"
#include "ui/editor/tools/moving.h"
#include "ui/editor/view/camera_text.h"
#include "ui/editor/view/piece_set.h"

namespace kerf {

namespace {

void copy_view(EditorState& state) {
  ImGui::SetClipboardText(view_text({state.view.seen().near().eye, state.view.camera.pivot()}).c_str());
  state.message.say("The view is in the clipboard as text");
}

void paste_view(EditorState& state) {
  const char* text = ImGui::GetClipboardText();
  const Result<View> view = parse_view_text(text != nullptr ? text : "");
  if (!view) return state.message.say(view.error().message, true);
  state.view.camera.look(view->eye, view->target);
  state.message.say("");
}

void choose_all(EditorState& state) {
  for (const PieceRow& row : list_pieces(state.work.document.world())) {
    PieceLook& look = state.view.look.pieces[row.id];
    look.selected = !look.hidden;
  }
  state.view.picture_old = true;
}

const char* why_no_undo(const EditorState& state) {
  return state.work.document.history().position() > 0 ? nullptr : "Nothing was done yet.";
}
const char* why_no_redo(const EditorState& state) {
  const History& history = state.work.document.history();
  return history.position() < history.size() ? nullptr : "Nothing was taken back.";
}
const char* why_none_hidden(const EditorState& state) {
  return hidden_pieces(state.view.look.pieces).empty() ? "No piece is hidden." : nullptr;
}

const char* why_no_rename(const PieceMap& looks) {
  if (const char* why = why_none_chosen(looks)) return why;
  return chosen_pieces(looks) > 1 ? "Several pieces are chosen: choose one alone to rename it." : nullptr;
}

void rename_chosen(EditorState& state) {
  KERF_ASSERT(chosen_pieces(state.view.look.pieces) == 1);
  state.settings.side_shown = true;
  state.settings.panels[PanelId::kPieces] = true;
  state.view.renaming = first_chosen(state.view.look.pieces);
}

// The key has its usual meaning unless the tool that picks is in hand and a piece is chosen.
UserAction move_action(EditorState& s, const char* name, const char* key, PieceMove::Kind kind) {
  return {
      .menu = "Edit",
      .name = name,
      .shortcut = key,
      .key = key[0],  // GLFW's keys of letters are the capitals
      .tip =
          "The chosen piece follows the pointer: X, Y and Z keep it to an axis, digits give the "
          "amount, Enter or a click ends it, Esc takes it back. The key does it with the tool that "
          "picks in hand.",
      .run =
          [&s, kind] {
            cancel_stroke(s.hand, s.work.document);
            begin_move(s.hand, s.view, s.work.document.world(), kind);
          },
      .why_not = [&s] { return why_no_move(s.view.look.pieces); },
      .has_key_when = [&s] { return s.hand.tool == Tool::kPick && chosen_pieces(s.view.look.pieces) > 0; }};
}

}  // namespace

std::vector<UserAction> history_actions(EditorState& s) {
  return {
      UserAction{.menu = "Edit",
                 .name = "Undo",
                 .shortcut = "Ctrl+Z",
                 .key = GLFW_KEY_Z,
                 .mods = kCtrl,
                 .tip = "Takes the last stroke or command back.",
                 .run = [&s] { s.requests.undo = true; },
                 .why_not = [&s] { return why_no_undo(s); }},
      UserAction{.menu = "Edit",
                 .name = "Redo",
                 .shortcut = "Ctrl+Shift+Z",
                 .key = GLFW_KEY_Z,
                 .mods = kCtrl | kShift,
                 .tip = "Does again what was taken back.",
                 .run = [&s] { s.requests.redo = true; },
                 .why_not = [&s] { return why_no_redo(s); },
                 .ends_group = true},
  };
}

std::vector<UserAction> view_text_actions(EditorState& s) {
  return {
      UserAction{.menu = "Edit",
                 .name = "Copy the view",
                 .shortcut = "Ctrl+C",
                 .key = GLFW_KEY_C,
                 .mods = kCtrl,
                 .tip = "Where the eye stands, as text.",
                 .run = [&s] { copy_view(s); }},
      UserAction{.menu = "Edit",
                 .name = "Paste the view",
                 .shortcut = "Ctrl+V",
                 .key = GLFW_KEY_V,
                 .mods = kCtrl,
                 .tip = "Looks from where the text in the clipboard says.",
                 .run = [&s] { paste_view(s); },
                 .ends_group = true},
  };
}

std::vector<UserAction> piece_actions(EditorState& s) {
  return {
      UserAction{.menu = "Edit",
                 .name = "Choose all pieces",
                 .shortcut = "Ctrl+A",
                 .key = GLFW_KEY_A,
                 .mods = kCtrl,
                 .tip = "All that are not hidden.",
                 .run = [&s] { choose_all(s); }},
      UserAction{.menu = "Edit",
                 .name = "Hide the chosen",
                 .shortcut = "H",
                 .key = GLFW_KEY_H,
                 .tip = "Leaves the chosen pieces out of the picture; the beam passes them by.",
                 .run = [&s] { s.requests.hide_chosen = true; },
                 .why_not = [&s] { return why_none_chosen(s.view.look.pieces); }},
      UserAction{.menu = "Edit",
                 .name = "Show all pieces",
                 .shortcut = "Shift+H",
                 .key = GLFW_KEY_H,
                 .mods = kShift,
                 .tip = "Draws the hidden pieces again.",
                 .run = [&s] { s.requests.show_hidden = true; },
                 .why_not = [&s] { return why_none_hidden(s); }},
      UserAction{.menu = "Edit",
                 .name = "Isolate the chosen",
                 .shortcut = "/",
                 .key = GLFW_KEY_SLASH,
                 .pad_key = GLFW_KEY_KP_DIVIDE,
                 .tip = "Hides all other pieces; the same again shows them as they were.",
                 .run = [&s] { s.requests.isolate = true; },
                 .why_not = [&s] { return why_no_isolation(s.work.document.world(), s.view); }},
      UserAction{
          .menu = "Edit",
          .name = "Rename the chosen",
          .shortcut = "F2",
          .key = GLFW_KEY_F2,
          .tip = "Edits the name of the chosen piece in the Pieces panel: Enter takes it, Esc does not.",
          .run = [&s] { rename_chosen(s); },
          .why_not = [&s] { return why_no_rename(s.view.look.pieces); }},
      UserAction{.menu = "Edit",
                 .name = "Delete the chosen",
                 .shortcut = "Del",
                 .key = GLFW_KEY_DELETE,
                 .tip = "Takes the chosen pieces out of the world.",
                 .run = [&s] { s.requests.delete_chosen = true; },
                 .why_not = [&s] { return why_none_chosen(s.view.look.pieces); },
                 .ends_group = true},
      move_action(s, "Move the chosen", "G", PieceMove::Kind::kMove),
      move_action(s, "Rotate the chosen", "R", PieceMove::Kind::kTurn),
      UserAction{.menu = "Edit",
                 .name = "Duplicate the chosen",
                 .shortcut = "Shift+D",
                 .key = GLFW_KEY_D,
                 .mods = kShift,
                 .tip = "Adds a copy of the chosen piece, which the pointer then moves.",
                 .run = [&s] { s.requests.duplicate_chosen = true; },
                 .why_not = [&s] { return why_no_move(s.view.look.pieces); }},
  };
}

}  // namespace kerf
