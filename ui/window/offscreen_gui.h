#pragma once

#include <functional>

#include "ui/gl/framebuffer.h"
#include "ui/window/gui_look.h"

namespace kerf {

// Runs ImGui without a window, to draw text and lines on pictures. An OpenGL context must be current while it
// exists, and no other ImGui context may be.
class OffscreenGui {
 public:
  explicit OffscreenGui(const GuiLook& look);
  ~OffscreenGui();
  OffscreenGui(const OffscreenGui&) = delete;
  OffscreenGui& operator=(const OffscreenGui&) = delete;

  // Draws over a picture what `paint` adds to ImGui's background list, in pixels from the upper left corner.
  // Precondition: it does not call this itself.
  void draw(const gl::Framebuffer& over, const std::function<void()>& paint);
};

}  // namespace kerf
