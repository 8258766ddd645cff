#pragma once

#include <span>

#include "ui/editor/editor_state.h"

namespace kerf {

// Something that the user can ask for by menu and by key: the menus, the keys and the F1 sheet are all made
// from this one table.
struct Action {
  const char* menu;
  const char* name;
  const char* shortcut = "";  // as it is written; empty: none
  int key = 0;                // GLFW_KEY_*; 0: none
  int mods = 0;               // GLFW_MOD_*
  const char* tip = "";
  void (*run)(EditorState&) = nullptr;
  bool (*checked)(const EditorState&) = nullptr;         // null: not a switch
  const char* (*why_not)(const EditorState&) = nullptr;  // a sentence where it cannot be done now, or null
  void (*submenu)(EditorState&) = nullptr;               // draws a menu of its own in place of all that
  bool ends_group = false;                               // a line under it in the menu
};
std::span<const Action> actions();

// Runs the action of a key; whether there is one. One that cannot be done now says why in the status bar.
bool run_shortcut(EditorState& state, int key, int mods);

// What the mouse does in the picture, for the F1 sheet.
struct Gesture {
  const char* gesture;
  const char* meaning;
};
std::span<const Gesture> gestures();

}  // namespace kerf
