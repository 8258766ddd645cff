#pragma once

#include <span>

#include "ui/editor/editor_state.h"

namespace kerf {

// A group of the column at the right. One pair of files each, and one line in panels.cpp.
struct Panel {
  const char* title;
  bool open_at_first;
  void (*draw)(EditorState&);
};
std::span<const Panel> panels();

// A menu that unfolds and folds them.
void draw_panels_menu(EditorState& state);

// Everything of ImGui's that is drawn around and over the picture, from the state's layout.
void draw_panels(EditorState& state);

}  // namespace kerf
