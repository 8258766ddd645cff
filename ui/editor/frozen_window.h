#pragma once

#include "core/base/vec3.h"
#include "ui/gl/objects.h"

namespace kerf {

// What a window showed, to be shown on while nobody may look at the document.
class FrozenWindow {
 public:
  // Keeps the picture that was drawn to the window and is not swapped yet; its size in pixels.
  void take(const Vec2& pixels);
  // Lays it under all that ImGui draws in this frame, over a window of this size.
  void draw(const Vec2& size) const;

 private:
  gl::Texture picture_;
};

}  // namespace kerf
