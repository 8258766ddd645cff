#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// The files that were open last; those that are gone are grey.
void draw_recent_menu(EditorState& state);

// The scenes that come with Kerf.
void draw_examples_menu(EditorState& state);

}  // namespace kerf
