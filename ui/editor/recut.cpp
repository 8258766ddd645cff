#include "ui/editor/recut.h"

namespace kerf {

const char* why_no_recut(const EditorState& state) {
  if (state.document.strokes() == 0) return "Nothing is cut yet.";
  if (state.document.in_stroke()) return "A stroke is being cut.";
  if (!state.document.can_recut())
    return "The scene is too large to be remembered before each stroke (more than 400 000 faces).";
  return nullptr;
}

void show_world(const EditorState& state, const World& world, Renderer& renderer) {
  if (state.as_loaded) {
    renderer.show(*state.as_loaded, state.paints);
    renderer.resend(world);
  } else {
    renderer.show(world, state.paints);
  }
}

void recut_last_stroke(EditorState& state, Renderer& renderer) {
  if (why_no_recut(state) != nullptr) return;
  CutSettings settings = state.document.stroke_settings();
  settings.resolution = state.laser.resolution.of(settings.laser.radius);
  state.document.recut(settings);
  show_world(state, state.document.world(), renderer);
  state.look.pieces.clear();
  state.removed_faces = state.removed_before_stroke;
  ++state.recuts;
  state.picture_old = state.world_changed = true;
  state.say("");
}

}  // namespace kerf
