#include "ui/editor/viewport_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>

namespace kerf {

namespace {

constexpr double kOrbitPerHeight = 3.6;  // radians for a drag over the height of the picture
constexpr double kZoomPerNotch = 0.88;

Drag drag_of(int button, int mods) {
  const bool shift = (mods & GLFW_MOD_SHIFT) != 0, alt = (mods & GLFW_MOD_ALT) != 0;
  switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT:
      return alt ? Drag::kOrbit : Drag::kCut;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return shift ? Drag::kPan : Drag::kOrbit;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return Drag::kPan;
    default:
      return Drag::kNone;
  }
}

void begin(EditorState& state, Drag drag) {
  state.drag = drag;
  if (drag != Drag::kCut) return;
  state.camera.finish();
  state.tool.press(state.document, state.view(), state.in_picture(state.pointer), state.laser);
  state.cut_once = true;
  state.say("");
}

void go_on(EditorState& state, Vec2 from) {
  const Vec2 moved = (state.pointer - from) / state.layout.viewport.size.y;
  switch (state.drag) {
    case Drag::kCut:
      state.tool.move(state.document, state.view(), state.in_picture(state.pointer),
                      2 / state.layout.viewport.size.y);
      break;
    case Drag::kOrbit:
      state.camera.orbit(-moved.x * kOrbitPerHeight, moved.y * kOrbitPerHeight);
      break;
    case Drag::kPan:
      state.camera.pan(2 * moved.x / state.aspect(), -2 * moved.y, state.aspect());
      break;
    case Drag::kNone:
      break;
  }
}

}  // namespace

bool cancel_stroke(EditorState& state) {
  if (state.drag != Drag::kCut) return false;
  state.tool.release(state.document);
  state.drag = Drag::kNone;
  return true;
}

void handle_mouse(EditorState& state, const InputEvent& event, bool free) {
  const Vec2 from = state.pointer;
  state.pointer = event.at;
  state.pointer_over_picture = free && state.layout.viewport.contains(event.at);
  switch (event.kind) {
    case InputEvent::Kind::kPress:
      if (state.drag == Drag::kNone && state.pointer_over_picture)
        begin(state, drag_of(event.button, event.mods));
      break;
    case InputEvent::Kind::kMove:
      go_on(state, from);
      break;
    case InputEvent::Kind::kRelease:
      if (state.drag == Drag::kCut && event.button == GLFW_MOUSE_BUTTON_LEFT) cancel_stroke(state);
      if (state.drag == Drag::kOrbit || state.drag == Drag::kPan) state.drag = Drag::kNone;
      break;
    case InputEvent::Kind::kWheel:
      if (state.pointer_over_picture && state.drag != Drag::kCut) {
        const Vec2 p = state.in_picture(event.at);
        state.camera.zoom(std::pow(kZoomPerNotch, event.wheel), p.x, p.y, state.aspect());
      }
      break;
    case InputEvent::Kind::kKey:
      break;
  }
}

}  // namespace kerf
