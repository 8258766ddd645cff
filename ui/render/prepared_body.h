#pragma once

#include <map>
#include <memory>

#include "core/shadow/shadow_caster.h"
#include "core/world/world.h"
#include "ui/render/base_faces.h"

namespace kerf {

// What pictures of a body need besides the body and takes long to find out: no OpenGL, so that it can be made
// ahead on another thread.
struct PreparedBody {
  FloatFrame frame;  // in which its faces are drawn
  BaseFaces bases;
  std::unique_ptr<ShadowCaster> caster;  // null: not made yet
};
using PreparedBodies = std::map<BodyId, PreparedBody>;

// The frame and the bases of a body as loaded, none of it cut; of all bodies of a world. O(n log n).
PreparedBody prepare_shading(const Body& body);
PreparedBodies prepare_shading(const World& world);
// Adds what casts the shadows of bodies that are prepared, as they are by now. Expected linear time.
void prepare_shadows(const World& world, PreparedBodies& prepared);

}  // namespace kerf
