#include "ui/editor/recut.h"

namespace kerf {

const char* why_no_recut(const EditorState& state) {
  if (state.document.strokes() == 0) return "Nothing is cut yet.";
  if (state.document.in_stroke()) return "A stroke is being cut.";
  if (!state.document.can_recut())
    return "The scene is too large to be remembered before each stroke (more than 400 000 faces).";
  return nullptr;
}

void recut_last_stroke(EditorState& state, Renderer& renderer) {
  if (why_no_recut(state) != nullptr) return;
  CutSettings settings = state.document.stroke_settings();
  settings.resolution = state.laser.resolution(settings.laser.radius);
  state.document.recut(settings);
  // Smooth normals come from the faces as they were loaded, whatever earlier strokes have done to them.
  if (state.as_loaded) {
    renderer.show(*state.as_loaded, state.paints);
    renderer.resend(state.document.world());
  } else {
    renderer.show(state.document.world(), state.paints);
  }
  state.look.pieces.clear();
  state.removed_faces = state.removed_before_stroke;
  ++state.recuts;
  state.picture_old = state.world_changed = true;
  state.say("");
}

}  // namespace kerf
