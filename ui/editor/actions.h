#pragma once

#include <span>
#include <vector>

#include "ui/editor/frame/user_action.h"
#include "ui/editor/panels/panel_column.h"
#include "ui/editor/state.h"

namespace kerf {

// What the user can ask for by menu and by key, menu after menu. The state and the panels must outlive it.
std::vector<UserAction> make_actions(EditorState& state, std::span<const Panel> panels);

// The groups of the menus, in this order.
std::vector<UserAction> open_actions(EditorState& state);
std::vector<UserAction> save_actions(EditorState& state);
std::vector<UserAction> output_actions(EditorState& state);
std::vector<UserAction> history_actions(EditorState& state);
std::vector<UserAction> view_text_actions(EditorState& state);
std::vector<UserAction> piece_actions(EditorState& state);
std::vector<UserAction> tool_actions(EditorState& state);
std::vector<UserAction> camera_actions(EditorState& state);
std::vector<UserAction> switch_actions(EditorState& state);
std::vector<UserAction> frame_actions(EditorState& state, std::span<const Panel> panels);
std::vector<UserAction> text_actions(EditorState& state);
std::vector<UserAction> help_actions(EditorState& state);

// What the mouse does in the picture.
std::span<const Gesture> gestures();

// Does what Esc asks for: the first of ending the stroke, stopping the files that are read, closing the sheet
// of shortcuts and letting go of the chosen pieces that there is anything to do for.
void escape(EditorState& state);

}  // namespace kerf
