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

// The frame and the bases of a body as loaded, none of it cut. Expected linear time.
PreparedBody prepare_shading(const Body& body);
// The same of every body of a world, or that it was stopped. `progress` may be null, here and below.
Result<PreparedBodies> prepare_shading(const World& world, const Progress* progress);
// Adds what casts the shadows of bodies that are prepared, as they are by now, or says that it was stopped.
// Expected linear time.
Status prepare_shadows(const World& world, PreparedBodies& prepared, const Progress* progress);

}  // namespace kerf
