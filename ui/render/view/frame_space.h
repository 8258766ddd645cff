#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/base/float_frame.h"
#include "core/mesh/files/mesh_format.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"
#include "ui/render/view/camera.h"

namespace kerf {

// The coordinates of the shaders: the axes of the world turned so that +Y points upwards (see to_y_up),
// with the eye of the near view (see CameraView) at the origin and lengths divided by `unit`, a power of
// two near the size of the world. Differences are computed in double, so that floats suffice at any place
// and size.
struct FrameSpace {
  Vec3 eye{0};        // of the near view
  Vec3 seen_from{0};  // the eye itself, which is farther away in an orthographic view
  double unit = 1;    // m
  UpAxis up = UpAxis::kY;

  glm::vec3 from_world(const Vec3& p) const { return glm::vec3(turned(p - eye) / unit); }
  // A direction or displacement of the world with +Y upwards, not divided by the unit.
  Vec3 turned(const Vec3& v) const { return to_y_up(v, up); }
  // The rotation of vectors from a frame with this orientation in the world.
  glm::dmat3 turn_from(const glm::dquat& orientation) const {
    const glm::dmat3 m = glm::mat3_cast(orientation);
    return {turned(m[0]), turned(m[1]), turned(m[2])};
  }
  float length(double metres) const { return static_cast<float>(metres / unit); }

  // The transformation from the float frame of a body with this placement.
  glm::mat4 from_body(const Placement& placement, const FloatFrame& frame) const {
    const glm::dmat3 turn = turn_from(placement.orientation) * (1 / (frame.scale * unit));
    const Vec3 origin = turned(placement.to_world(frame.origin) - eye) / unit;
    return glm::mat4(glm::dmat4(glm::dvec4(turn[0], 0), glm::dvec4(turn[1], 0), glm::dvec4(turn[2], 0),
                                glm::dvec4(origin, 1)));
  }
};

// The colours of a scene's environment in linear light, a part of the uniform block "Frame"; frame.glsl
// documents its members. They are uniforms because a software renderer would recompute them for every
// pixel.
struct StageColours {
  glm::vec4 sky_high{0}, sky_low{0}, sky_band{0};
  glm::vec4 sky_light{0}, ground_light{0};
  glm::vec4 ground_matt{0}, ground_line{0};
};

// The colours of a workshop at dusk, or by day.
const StageColours& stage_colours(bool by_day);
// The same for an eye below the ground, which is then not drawn: a lamp lights the target from below, and
// the environment is brighter.
StageColours stage_colours_from_below(bool by_day);

// The uniform block "Frame" of the shaders; frame.glsl documents its members.
struct FrameUniforms {
  glm::mat4 clip_from_frame{1};
  glm::vec4 camera_right{0}, camera_up{0}, camera_forward{0};
  glm::vec4 viewport{0};
  glm::vec4 key_light{0};
  glm::vec4 ground{0};
  glm::vec4 grid{0};
  glm::vec4 spot{0};
  glm::vec4 spot_colour{0};
  glm::vec4 beam{0};
  StageColours stage;
  glm::vec4 section{0, 0, 0, 1};
  glm::vec4 body_look{0};
  glm::vec4 face_view{0};
};

// The distance of the near plane along the forward axis of a view [m]: as large as the visible box and the
// ground (at its height, m) allow, because the resolution of the depth buffer is proportional to it, and at
// least a fraction of the focus. An orthographic view has the same depth range in front of its focus as
// behind it: there the plane lies so far before the focus that the box and the ground fit in, even if that
// is behind the eye.
double near_plane(const CameraView& view, const World::Bounds& drawn, double ground);

// The depth-buffer value of a depth along the forward axis [m], from 0 at the near plane to 1.
// Precondition: in a perspective view the depth is positive.
double window_depth(const CameraView& view, double near, double depth);

// The members that depend on the view: the matrix (near plane at `near` metres; no far plane, but in an
// orthographic view one equally far behind the focus), the axes and the viewport. Precondition: the near
// plane is that of near_plane.
FrameUniforms uniforms_of(const CameraView& view, double near, const FrameSpace& space, int width,
                          int height);

// The height [m, along the up axis] of the drawn ground: the ground of the world if there is one and it is
// perpendicular to the up axis, else slightly below the lowest point of the bodies as loaded.
double height_of_drawn_ground(const World& world, UpAxis up);

// The environment with the drawn ground, and earth gravity against the up axis in the unit of the file.
Environment default_environment(const World& world, const FileFrame& frame);

// The environment for simulation: that of the world, with gravity in the unit of the file; the default one
// if there is gravity and no ground yet.
Environment fitting_environment(const World& world, const FileFrame& frame);

inline constexpr float kUsualHeight = 900;  // of a frame, pixels; same value in line.glsl

// Scales a line width [pixels] for frames of up to the usual height to one of this height.
inline float scaled_width(float width, int height) {
  return width * std::max(1.0f, static_cast<float>(height) / kUsualHeight);
}

}  // namespace kerf
