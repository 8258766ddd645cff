#pragma once

#include <span>

#include "ui/editor/editor_state.h"

namespace kerf {

// Something that the user can ask for by menu and by key: the menus, the keys and the F1 sheet are all made
// from this one table.
struct Action {
  const char* menu;
  const char* name;
  const char* shortcut;  // as it is written; empty: none
  int key;               // GLFW_KEY_*; 0: none
  int mods;              // GLFW_MOD_CONTROL or 0
  void (*run)(EditorState&);
  bool (*checked)(const EditorState&);  // null: not a switch
};
std::span<const Action> actions();

// Runs the action of a key; whether there is one.
bool run_shortcut(EditorState& state, int key, int mods);

// What the mouse does in the picture, for the F1 sheet.
struct Gesture {
  const char* gesture;
  const char* meaning;
};
std::span<const Gesture> gestures();

}  // namespace kerf
