#include "ui/editor/actions.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "ui/editor/viewport_input.h"

namespace kerf {

namespace {

// A switch of the view that is stored in a flag of ShowOptions.
template <bool ShowOptions::*flag>
void flip(EditorState& state) {
  state.look.show.*flag = !(state.look.show.*flag);
  state.picture_old = true;
}
template <bool ShowOptions::*flag>
bool shown(const EditorState& state) {
  return state.look.show.*flag;
}

void frame_all(EditorState& state) { state.camera.frame(state.document.world().bounds(), state.aspect()); }

void go_home(EditorState& state) {
  if (state.home) {
    state.camera.look(state.home->eye, state.home->target);
  } else {
    state.camera.frame_default(state.document.world().bounds(), state.aspect());
  }
}

void flip_levels(EditorState& state) {
  state.look.level_colours = !state.look.level_colours;
  state.picture_old = true;
}
void flip_antialias(EditorState& state) {
  state.look.antialias = !state.look.antialias;
  state.picture_old = true;
}

constexpr std::array kActions{
    Action{"File", "Quit", "Ctrl+Q", GLFW_KEY_Q, GLFW_MOD_CONTROL, [](EditorState& s) { s.quit = true; },
           nullptr},
    Action{"View", "Frame all", "F", GLFW_KEY_F, 0, frame_all, nullptr},
    Action{"View", "First view", "Home", GLFW_KEY_HOME, 0, go_home, nullptr},
    Action{"View", "Level colouring", "", 0, 0, flip_levels,
           [](const EditorState& s) { return s.look.level_colours; }},
    Action{"View", "Wire", "W", GLFW_KEY_W, 0, flip<&ShowOptions::wire>, shown<&ShowOptions::wire>},
    Action{"View", "Boxes of the tree", "B", GLFW_KEY_B, 0, flip<&ShowOptions::aabb>,
           shown<&ShowOptions::aabb>},
    Action{"View", "Boxes that the beam met", "", 0, 0, flip<&ShowOptions::aabb_hit>,
           shown<&ShowOptions::aabb_hit>},
    Action{"View", "Pieces", "P", GLFW_KEY_P, 0, flip<&ShowOptions::pieces>, shown<&ShowOptions::pieces>},
    Action{"View", "Normals", "N", GLFW_KEY_N, 0, flip<&ShowOptions::normals>, shown<&ShowOptions::normals>},
    Action{"View", "Anti-aliasing", "", 0, 0, flip_antialias,
           [](const EditorState& s) { return s.look.antialias; }},
    Action{"Help", "Shortcuts", "F1", GLFW_KEY_F1, 0,
           [](EditorState& s) { s.show_shortcuts = !s.show_shortcuts; },
           [](const EditorState& s) { return s.show_shortcuts; }},
};

constexpr std::array kGestures{
    Gesture{"Left drag", "Cut where the pointer goes"},
    Gesture{"Middle drag, Alt+left drag", "Orbit"},
    Gesture{"Shift+middle drag, right drag", "Pan"},
    Gesture{"Wheel", "Zoom to the pointer"},
    Gesture{"Esc", "End the cut"},
};

}  // namespace

std::span<const Action> actions() { return kActions; }
std::span<const Gesture> gestures() { return kGestures; }

bool run_shortcut(EditorState& state, int key, int mods) {
  if (key == GLFW_KEY_ESCAPE) {
    if (!cancel_stroke(state)) state.show_shortcuts = false;
    return true;
  }
  constexpr int kCounted = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  for (const Action& action : kActions) {
    if (action.key != key || key == 0 || action.mods != (mods & kCounted)) continue;
    action.run(state);
    return true;
  }
  return false;
}

}  // namespace kerf
