#include "ui/editor/editor_state.h"

namespace kerf {

Vec2 EditorState::in_picture(Vec2 at) const {
  const Vec2 p = (at - pane().at) / pane().size;
  return {2 * p.x - 1, 1 - 2 * p.y};
}

void EditorState::say(std::string text, bool error) {
  message = std::move(text);
  message_is_error = error;
}

void EditorState::note_figures(const StepFigures& step) {
  const size_t current = document.revision();
  if (figures_of != current) stroke_figures = {};
  figures_of = current;
  stroke_figures.add(step);
}

}  // namespace kerf
