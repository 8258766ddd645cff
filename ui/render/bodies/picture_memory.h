#pragma once

#include <cstddef>

namespace kerf {

// Memory used for drawing a world, in bytes.
struct PictureMemory {
  size_t shading = 0;   // smooth normals of the faces as loaded
  size_t shadows = 0;   // casters and shadow volumes
  size_t graphics = 0;  // graphics buffers and the lists of their contents

  PictureMemory& operator+=(const PictureMemory& more) {
    shading += more.shading;
    shadows += more.shadows;
    graphics += more.graphics;
    return *this;
  }
};

}  // namespace kerf
