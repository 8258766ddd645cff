#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>

#include "core/base/geometry.h"
#include "core/mesh/files/mesh_format.h"
#include "core/tree/swept_cylinder.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"

namespace kerf {

// A view in world coordinates and double precision: perspective, or orthographic with rays parallel to
// `forward`. An orthographic view is represented by the perspective view of which it is the limit: the eye
// is kFarAway times as far from the target, and the field of view is narrower by this factor, so that
// lengths at the distance `focus` keep their apparent size.
struct CameraView {
  Vec3 eye{0, 0, 1};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};  // orthonormal
  double focus = 1;                                     // m, distance of the view target
  double tan_half_fov = 0.3;                            // of half the vertical field of view
  double aspect = 16.0 / 9;                             // width over height
  UpAxis up_axis = UpAxis::kY;                          // axis of the world that is up in the frame
  bool parallel = false;                                // orthographic
  double pull = 1;                                      // factor of the eye's distance relative to near()

  static constexpr double kFarAway = 1000;

  friend bool operator==(const CameraView&, const CameraView&) = default;

  // Half the visible height [m] at the distance `focus`.
  double half_height() const { return focus * tan_half_fov; }
  // Returns the ray through a point of the frame, from the eye or, in an orthographic view, from the plane
  // of the eye: x from -1 (left) to 1 (right), y from -1 (bottom) to 1 (top).
  Pose ray(double x, double y) const;
  // Returns the point of the frame at which p is seen, with its depth along `forward` [m] as z; x and y are
  // undefined if z <= 0.
  Vec3 project(const Vec3& p) const;
  // Returns the perspective view with the usual field of view that shows lengths at the distance `focus` at
  // the same size.
  CameraView near() const;
  // Returns the view whose eye is `times` times as far away as that of near(), orthographic from kFarAway
  // on. Precondition: times > 0.
  CameraView pulled(double times) const;
};

// Returns the view from an eye to a target; the nearest valid view if the target coincides with the eye or
// lies vertically above or below it. Precondition: aspect > 0.
CameraView look_at(const Vec3& eye, const Vec3& target, double aspect);

// A turntable camera: the eye orbits on a sphere around a pivot and stops short of the poles. Movements set a
// goal, and advance() eases the view towards it by nine tenths of the distance in 100 ms.
class Camera {
 public:
  // Frames the box in a three-quarter view: from the front (+Z), turned to the right and slightly from above,
  // so that it fills the fraction `fill` of the frame's height. Precondition: aspect and fill are positive.
  void frame_default(const World::Bounds& bounds, double aspect, double fill = 0.64);
  // Frames the box without a change of direction.
  void frame(const World::Bounds& bounds, double aspect, double fill = 0.72);
  void look(const Vec3& eye, const Vec3& target);

  // Sets the up axis of the world, at once. Yaw, pitch and "front" are those of a world turned so that +Y
  // points upwards (see to_y_up).
  void set_up_axis(UpAxis up) { now_.up = goal_.up = up; }
  UpAxis up_axis() const { return goal_.up; }

  // Turns by the shorter way to a view direction: yaw and pitch of the eye as seen from the pivot, in
  // radians from +Z towards +X, and above the horizon.
  void turn_to(double yaw, double pitch);
  // The unit vector from the pivot to the eye, with +Y upwards.
  static Vec3 direction_of(double yaw, double pitch);
  // Returns true if the camera is at, or on its way to, such a direction.
  bool is_turned_to(double yaw, double pitch) const;
  // Makes the projection orthographic, or perspective again; lengths at the pivot keep their apparent size.
  void set_parallel(bool parallel);
  bool parallel() const { return goal_.pull > 0; }

  void orbit(double right, double up);  // angles in radians around the pivot
  // Shifts the view so that points at the depth of the pivot move by (dx, dy) in the frame, in the units of
  // CameraView::ray.
  void pan(double dx, double dy, double aspect);
  // Multiplies the distance by `factor` and keeps the point at the pivot's depth under x, y in place.
  void zoom(double factor, double x, double y, double aspect);

  // Advances the motion by a time [s]. Returns true if the camera is still moving.
  bool advance(double seconds);
  void finish() { now_ = goal_; }

  CameraView view(double aspect) const { return view_of(now_, aspect); }
  Vec3 pivot() const { return now_.pivot; }

  static constexpr double kTanHalfFov = 0.3057;  // 34 degrees vertically; more in a narrow frame

 private:
  struct State {
    Vec3 pivot{0};
    double distance = 1;
    double yaw = 0;    // radians from +Z towards +X
    double pitch = 0;  // radians above the horizon
    double pull = 0;   // logarithm of CameraView::pull
    UpAxis up = UpAxis::kY;
  };
  static CameraView view_of(const State& state, double aspect);
  static void fit(State& state, const World::Bounds& bounds, double aspect, double fill);

  State now_, goal_;
};

// A straight segment projected to the frame.
struct ScreenSegment {
  Vec2 from, to;  // its ends in pixels, from the lower left corner of the frame
  // 1 / m along the view's axis, at both ends, linear between them in the frame; in an orthographic view
  // both are that of the focus
  Vec2 inverse_depth;
  Vec2 share;  // fractions of the whole segment in front of both ends, 0 to 1
};

// Returns the visible part of the segment between two points of the world [m], clipped in double precision
// against the plane of the eye and against the sides of the frame moved outward by `margin` pixels. Method:
// Liang and Barsky, A new concept and method for line clipping, 1984, in homogeneous coordinates. Empty if
// nothing is visible. The frame is width x height pixels, both positive.
std::optional<ScreenSegment> on_screen(const CameraView& view, const Vec3& from, const Vec3& to, int width,
                                       int height, double margin);

// The coordinates of the shaders: the axes of the world turned so that +Y points upwards (see to_y_up),
// with the eye of the near view (see CameraView) at the origin and lengths divided by `unit`, a power of
// two near the size of the world. Differences are computed in double, so that floats suffice at any place
// and size.
struct FrameSpace {
  Vec3 eye{0};        // of the near view
  Vec3 seen_from{0};  // the eye itself, which is farther away in an orthographic view
  double unit = 1;    // m
  double size = 1;    // m, > 0; diagonal of the world when it was first shown
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

// Returns the distance of the near plane along the forward axis of a view [m]. In a perspective view it is as
// large as the visible box and the ground (at its height, m) allow, because the resolution of the depth
// buffer is proportional to it, and at least a fraction of the focus. In an orthographic view, whose depth
// range extends equally in front of and behind the focus, the plane lies in front of the box and the ground,
// even if that is behind the eye.
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

// The environment for simulation: that of the world, with gravity and the lengths of contact in the unit of
// the file; the default one if there is gravity and no ground yet.
Environment fitting_environment(const World& world, const FileFrame& frame);

inline constexpr float kUsualHeight = 900;  // of a frame, pixels; same value in line.glsl

// Scales a line width [pixels] for frames of up to the usual height to one of this height.
inline float scaled_width(float width, int height) {
  return width * std::max(1.0f, static_cast<float>(height) / kUsualHeight);
}

}  // namespace kerf
