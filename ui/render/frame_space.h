#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/base/float_frame.h"
#include "core/world/placement.h"
#include "core/world/world.h"
#include "ui/render/camera.h"

namespace kerf {

// The coordinates that shaders work in: the axes of the world, the eye at the origin, lengths over a power of
// two near the size of the world. Differences are taken in double, so floats do anywhere and at any size.
struct FrameSpace {
  Vec3 eye{0};
  double unit = 1;  // m

  glm::vec3 from_world(const Vec3& p) const { return glm::vec3((p - eye) / unit); }
  float length(double metres) const { return static_cast<float>(metres / unit); }

  // The float frame of a body that stands at `placement`, as a matrix.
  glm::mat4 from_body(const Placement& placement, const FloatFrame& frame) const {
    const glm::dmat3 turn = glm::mat3_cast(placement.orientation) * (1 / (frame.scale * unit));
    const Vec3 origin = (placement.to_world(frame.origin) - eye) / unit;
    return glm::mat4(glm::dmat4(glm::dvec4(turn[0], 0), glm::dvec4(turn[1], 0), glm::dvec4(turn[2], 0),
                                glm::dvec4(origin, 1)));
  }
};

// The block "Frame" of the shaders (frame.glsl), which says what each member means.
struct FrameUniforms {
  glm::mat4 clip_from_frame{1};
  glm::vec4 camera_right{0}, camera_up{0}, camera_forward{0};
  glm::vec4 viewport{0};
  glm::vec4 key_light{0};
  glm::vec4 ground{0};
  glm::vec4 grid{0};
  glm::vec4 spot{0};
  glm::vec4 spot_colour{0};
  glm::vec4 heat{0};
};

// Where the near plane goes, along the forward axis of a view; m. As far as the box and the ground (a height)
// allow that are seen, since the depth buffer tells surfaces apart in proportion to it; at least a fraction
// of the focus.
double near_plane(const CameraView& view, const World::Bounds& drawn, double ground);

// What the view decides of it: the matrix (no far plane, the near plane at `near` m), the axes, the viewport.
FrameUniforms uniforms_of(const CameraView& view, double near, const FrameSpace& space, int width,
                          int height);

}  // namespace kerf
