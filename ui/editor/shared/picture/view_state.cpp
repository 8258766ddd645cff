#include "ui/editor/shared/picture/view_state.h"

namespace kerf {

Vec2 ViewState::in_picture(Vec2 at) const {
  const Vec2 p = (at - pane().at) / pane().size;
  return {2 * p.x - 1, 1 - 2 * p.y};
}

Vec2 ViewState::in_first(Vec2 at) const {
  const Vec2 p = (at - layout.first.at) / layout.first.size;
  return {2 * p.x - 1, 1 - 2 * p.y};
}

void go_home(ViewState& view, const World::Bounds& bounds) {
  if (view.home) {
    view.camera.look(view.home->eye, view.home->target);
  } else {
    view.camera.frame_default(bounds, view.aspect());
  }
}

}  // namespace kerf
