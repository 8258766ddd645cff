#pragma once

#include "core/shadow/light.h"
#include "core/shadow/shadow_volume.h"
#include "core/world/placement.h"
#include "ui/render/bodies/body_looks.h"
#include "ui/render/view/frame_space.h"

namespace kerf {

// A light as a body sees it that stands at `placement` and has these looks.
LightOnBody light_on_body(const Light& light, const Placement& placement, const FloatFrame& frame,
                          const BodyLooks& looks);

// The uniform "light" of the shaders: the light in frame coordinates. Precondition: the direction of a
// directional light is not zero.
glm::vec4 light_in_frame(const Light& light, const FrameSpace& space);

// The uniform "light_colour". `diagonal` of the world, m.
glm::vec4 light_colour(const Light& light, const FrameSpace& space, double diagonal);

// The unit direction from a point of the world towards a light.
Vec3 direction_to(const Light& light, const Vec3& from);

}  // namespace kerf
