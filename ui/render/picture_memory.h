#pragma once

#include <cstddef>

namespace kerf {

// Memory that pictures of a world need, bytes.
struct PictureMemory {
  size_t shading = 0;   // smooth normals of the faces as loaded
  size_t shadows = 0;   // what casts, and what lies in shadow of what
  size_t graphics = 0;  // buffers for the graphics card, and the lists of what is in them

  PictureMemory& operator+=(const PictureMemory& more) {
    shading += more.shading;
    shadows += more.shadows;
    graphics += more.graphics;
    return *this;
  }
};

}  // namespace kerf
