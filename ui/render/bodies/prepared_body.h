#pragma once

#include <cstddef>
#include <map>
#include <memory>

#include "core/shadow/shadow_volume.h"
#include "core/world/world.h"
#include "ui/render/bodies/base_faces.h"

namespace kerf {

// The shading of a body as loaded. Immutable, and shared by all pieces copied out of the body.
struct LoadedShading {
  FloatFrame frame;
  std::shared_ptr<const BaseFaces> bases;
};
using LoadedShadings = std::map<BodyId, LoadedShading>;  // by Body::loaded_as

// Data for drawing a body that take long to compute. They involve no OpenGL, so another thread can prepare
// them.
struct PreparedBody {
  FloatFrame frame;  // frame in which its faces are drawn
  std::shared_ptr<const BaseFaces> bases;
  std::unique_ptr<ShadowCaster> caster;  // null if not prepared yet
};
using PreparedBodies = std::map<BodyId, PreparedBody>;

// Prepares the frame and the bases of a body: those of `loaded` if it has them, so that a piece is shaded
// like its body, otherwise new ones from its faces, which should be as loaded. Expected linear time.
PreparedBody prepare_shading(const Body& body, const LoadedShadings& loaded = {});
// Prepares the shading of every body of a world as loaded, or fails with cancelled() if stopped. `progress`
// may be null, here and below.
Result<PreparedBodies> prepare_shading(const World& world, const Progress* progress);
// Adds the shadow casters of prepared bodies, in their current state, or fails with cancelled() if stopped.
// Expected linear time.
Status prepare_shadows(const World& world, PreparedBodies& prepared, const Progress* progress);
// Prepares shading and shadows concurrently, for a world as loaded and uncut.
Result<PreparedBodies> prepare_drawing(const World& world, const Progress* progress);

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
