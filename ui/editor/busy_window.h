#pragma once

#include <utility>
#include <vector>

#include "ui/editor/editor_state.h"
#include "ui/editor/gui.h"
#include "ui/editor/window.h"
#include "ui/gl/objects.h"

namespace kerf {

// The window while long work is done and nobody may look at the document: what it showed last, under a bar
// that says how far the work is.
class BusyWindow {
 public:
  // What was drawn to the window and is not swapped yet is shown from now on; its size in pixels.
  void keep(const Vec2& pixels);
  // A frame. Escape, the button beside the bar and closing the window stop the work; other keys wait.
  void show(EditorState& state, Window& window, Gui& gui);
  // Keys that were pressed meanwhile, once.
  std::vector<InputEvent> take_typed() { return std::exchange(typed_, {}); }

 private:
  void hear(EditorState& state, Window& window);
  void draw_kept(const Vec2& size) const;

  gl::Texture kept_;
  std::vector<InputEvent> typed_;
};

}  // namespace kerf
