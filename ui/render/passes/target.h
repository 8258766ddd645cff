#pragma once

#include <glm/vec2.hpp>

#include "ui/gl/objects.h"

namespace kerf {

// The destination of a picture: a rectangle of a framebuffer (0: the window) in pixels from its lower left
// corner.
struct Target {
  GLuint framebuffer = 0;
  int x = 0, y = 0;
  int width = 1, height = 1;
  glm::vec2 shift{0};  // pixels by which the scene is drawn beside its place
};

}  // namespace kerf
