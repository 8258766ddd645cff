#include "ui/editor/tools/viewport_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>

#include "ui/editor/tools/light_handle.h"
#include "ui/editor/tools/piece_set.h"
#include "ui/render/pick.h"

namespace kerf {

namespace {

constexpr double kOrbitPerHeight = 3.6;  // radians for a drag over the height of the picture
constexpr double kZoomPerNotch = 0.88;

constexpr double kClick = 4;  // screen coordinates that the pointer may move and it is a click still

Drag drag_of(Tool tool, int button, int mods) {
  const bool shift = (mods & GLFW_MOD_SHIFT) != 0, alt = (mods & GLFW_MOD_ALT) != 0;
  switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT:
      if (alt) return Drag::kOrbit;
      return tool == Tool::kPick || (mods & GLFW_MOD_CONTROL) != 0 ? Drag::kPick : Drag::kCut;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return shift ? Drag::kPan : Drag::kOrbit;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return Drag::kPan;
    default:
      return Drag::kNone;
  }
}

// The beam cuts pieces where they stand, so they are drawn there.
void stand_together(EditorState& state) {
  if (state.spread == 0) return;
  state.spread = 0;
  spread_pieces(state.document.world(), 0, state.look.pieces);
}

void pick_piece(EditorState& state, int mods) {
  if (state.in_second) return state.say("Pieces are chosen in the left half.", true);
  const Vec2 p = state.in_picture(state.pointer);
  const World& world = state.document.world();
  const std::optional<Pick> seen = pick(world, state.look, state.view().ray(p.x, p.y));
  const bool add = (mods & GLFW_MOD_SHIFT) != 0;
  if (seen) {
    choose_piece(state.look.pieces, {seen->body, world.body(seen->body).mesh.data(seen->face).piece}, add);
  } else if (!add) {
    choose_none(state.look.pieces);
  }
  state.picture_old = true;
}

void begin(EditorState& state, Drag drag) {
  state.drag = drag;
  state.pressed_at = state.pointer;
  if (drag == Drag::kCut || drag == Drag::kPick) {
    if (const auto light = light_under(state, state.pointer)) {
      state.drag = Drag::kLight;
      state.dragged_light = *light;
      return;
    }
  }
  if (drag != Drag::kCut) return;
  if (state.loader.busy()) {
    state.drag = Drag::kNone;
    return state.say("The laser waits until " + state.loader.order().name() + " is open.");
  }
  stand_together(state);
  state.camera.finish();
  state.tool.press(state.document, state.view(), state.in_picture(state.pointer), state.laser);
  state.cut_once = true;
  state.say("");
}

void go_on(EditorState& state, Vec2 from) {
  const Vec2 moved = (state.pointer - from) / state.pane().size.y;
  switch (state.drag) {
    case Drag::kCut:
      state.tool.move(state.document, state.view(), state.in_picture(state.pointer), 2 / state.pane().size.y);
      break;
    case Drag::kPick:
      if (glm::length(state.pointer - state.pressed_at) > kClick) state.drag = Drag::kOrbit;
      break;
    case Drag::kOrbit:
      state.camera.orbit(-moved.x * kOrbitPerHeight, moved.y * kOrbitPerHeight);
      break;
    case Drag::kPan:
      state.camera.pan(2 * moved.x / state.aspect(), -2 * moved.y, state.aspect());
      break;
    case Drag::kLight:
      drag_light(state, state.dragged_light, state.pointer);
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

void show_split(EditorState& state, bool shown) {
  cancel_stroke(state);
  state.split.shown = shown;
  state.split.twin.forget();
  state.in_second = false;
  state.picture_old = true;
}

void handle_mouse(EditorState& state, const InputEvent& event, bool free) {
  const Vec2 from = state.pointer;
  state.pointer = event.at;
  state.pointer_over_picture = free && state.layout.viewport.contains(event.at);
  if (state.drag == Drag::kNone) state.in_second = state.layout.second.contains(event.at);
  switch (event.kind) {
    case InputEvent::Kind::kPress:
      if (state.drag == Drag::kNone && state.pointer_over_picture)
        begin(state, drag_of(state.left_button, event.button, event.mods));
      break;
    case InputEvent::Kind::kMove:
      go_on(state, from);
      break;
    case InputEvent::Kind::kRelease:
      if (state.drag == Drag::kCut && event.button == GLFW_MOUSE_BUTTON_LEFT) cancel_stroke(state);
      if (state.drag == Drag::kPick) {
        pick_piece(state, event.mods);
        state.drag = Drag::kNone;
      }
      if (state.drag == Drag::kOrbit || state.drag == Drag::kPan || state.drag == Drag::kLight)
        state.drag = Drag::kNone;
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
