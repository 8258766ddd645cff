#include "ui/editor/changes/recut.h"

#include "ui/editor/changes/change_world.h"

namespace kerf {

const char* why_no_recut(const EditorState& state) {
  if (!state.document.has_stroke()) return "Nothing is cut yet.";
  if (state.document.in_stroke()) return "A stroke is being cut.";
  if (!state.document.can_recut()) return "What was before the last stroke is no longer remembered.";
  return nullptr;
}

void recut_last_stroke(EditorState& state, Renderer& renderer) {
  if (why_no_recut(state) != nullptr) return;
  CutSettings settings = state.document.stroke_settings();
  settings.resolution = state.laser.resolution.of(settings.laser.radius);
  cut_again(state, renderer, settings);
  ++state.recuts;
}

}  // namespace kerf
