#pragma once

#include <span>
#include <vector>

#include "ui/editor/bodies/body_actions.h"
#include "ui/editor/frame/user_action.h"
#include "ui/editor/panels/panel_column.h"
#include "ui/editor/state.h"

namespace kerf {

// All actions that menus and keys offer, in the order of the menus. The state and the panels must outlive
// them.
std::vector<UserAction> make_actions(EditorState& state, std::span<const Panel> panels);

// The groups of actions in the menus, in this order.
std::vector<UserAction> open_actions(EditorState& state);
std::vector<UserAction> save_actions(EditorState& state);
std::vector<UserAction> output_actions(EditorState& state);
std::vector<UserAction> history_actions(EditorState& state);
std::vector<UserAction> view_text_actions(EditorState& state);
std::vector<UserAction> piece_actions(EditorState& state);
std::vector<UserAction> tool_actions(EditorState& state);
std::vector<UserAction> path_actions(EditorState& state);
std::vector<UserAction> emitter_actions(EditorState& state);
std::vector<UserAction> stage_actions(EditorState& state);
std::vector<UserAction> prepare_actions(EditorState& state);
std::vector<UserAction> camera_actions(EditorState& state);
std::vector<UserAction> switch_actions(EditorState& state);
std::vector<UserAction> frame_actions(EditorState& state, std::span<const Panel> panels);
std::vector<UserAction> text_actions(EditorState& state);
std::vector<UserAction> help_actions(EditorState& state);
// Those that panels offer beside the menus: of the laser, its resolution, the lights and so on.
std::vector<UserAction> laser_actions(EditorState& state);
std::vector<UserAction> stage_view_actions(EditorState& state);
std::vector<UserAction> light_actions(EditorState& state);
std::vector<UserAction> shown_actions(EditorState& state);
std::vector<UserAction> section_actions(EditorState& state);

// What the actions and the panel of moving bodies work on. The state must outlive them.
BodyParts body_parts(EditorState& state);

// Explanations of what the mouse does in the picture.
std::span<const Gesture> gestures();

// Performs the Esc key: ends the stroke, else stops reading files, else closes the sheet of shortcuts and the
// log of messages, else deselects all pieces.
void escape(EditorState& state);

}  // namespace kerf
