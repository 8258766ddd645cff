#pragma once

#include <map>
#include <memory>

#include "core/shadow/shadow_caster.h"
#include "core/world/world.h"
#include "ui/render/base_faces.h"

namespace kerf {

// Data for drawing a body that take long to compute. They involve no OpenGL, so that they can be prepared on
// another thread.
struct PreparedBody {
  FloatFrame frame;  // the frame in which its faces are drawn
  BaseFaces bases;
  std::unique_ptr<ShadowCaster> caster;  // null if not prepared yet
};
using PreparedBodies = std::map<BodyId, PreparedBody>;

// Prepares the frame and the bases of a body. Precondition: the body is as loaded. Expected linear time.
PreparedBody prepare_shading(const Body& body);
// The same for every body of a world, or fails with cancelled() when stopped. `progress` may be null, here
// and below.
Result<PreparedBodies> prepare_shading(const World& world, const Progress* progress);
// Adds the shadow casters of prepared bodies, in their current state, or fails with cancelled() when stopped.
// Expected linear time.
Status prepare_shadows(const World& world, PreparedBodies& prepared, const Progress* progress);

}  // namespace kerf
