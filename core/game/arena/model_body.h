#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/document/files/scene_joint.h"
#include "core/world/world.h"

namespace kerf {

// A body as loaded, of which copies are added to worlds, and the joints within it.
struct ModelBody {
  Body body;
  std::vector<Joint> joints;  // of the body in the world to which it will be added
};

// Adds the joints of a scene to a body. Fails like make_joint.
Status add_joints(std::span<const SceneJoint> joints, ModelBody& model);

// Adds a copy of the body with its joints to a world.
BodyId add_body(World& world, const ModelBody& model, uint32_t generation);

}  // namespace kerf
