#include "ui/render/view/frame_space.h"

#include <limits>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kNear = 0.004;       // of the distance to the view target
constexpr double kRoom = 0.7;         // of the minimum visible depth
constexpr double kParallelRoom = 16;  // in diagonals of the drawn bodies: more than the radius of the ground

constexpr StageColours kDusk = {.sky_high = {0.0048, 0.0064, 0.0100, 0},
                                .sky_low = {0.030, 0.038, 0.050, 0},
                                .sky_band = {0.034, 0.030, 0.025, 0},
                                .sky_light = {0.30, 0.37, 0.47, 0},
                                .ground_light = {0.115, 0.105, 0.095, 0},
                                .ground_matt = {0.060, 0.061, 0.063, 0},
                                .ground_line = {0.014, 0.0155, 0.018, 0}};

constexpr StageColours kDay = {.sky_high = {0.33, 0.40, 0.49, 0},
                               .sky_low = {0.58, 0.62, 0.66, 0},
                               .sky_band = {0.10, 0.09, 0.08, 0},
                               .sky_light = {0.52, 0.57, 0.64, 0},
                               .ground_light = {0.30, 0.29, 0.28, 0},
                               .ground_matt = {0.40, 0.41, 0.42, 0},
                               .ground_line = {-0.063, -0.06975, -0.081, 0}};

// From the axes of the view with the eye of the near view at the origin.
glm::mat4 projection(const CameraView& view, double near, const FrameSpace& space) {
  const double back = (view.focus - view.near().focus) / space.unit, n = near / space.unit;
  glm::dmat4 p(0);
  if (view.parallel) {
    const double half_height = view.half_height() / space.unit, depth = 2 * (view.focus - near) / space.unit;
    p[0][0] = 1 / (half_height * view.aspect);
    p[1][1] = 1 / half_height;
    p[2][2] = -2 / depth;
    p[3][2] = 2 * (back - n) / depth - 1;
    p[3][3] = 1;
  } else {
    p[0][0] = 1 / (view.tan_half_fov * view.aspect);
    p[1][1] = 1 / view.tan_half_fov;
    p[2][2] = -1;
    p[2][3] = -1;
    p[3][2] = back - 2 * n;
    p[3][3] = back;
  }
  return glm::mat4(p);
}

glm::mat4 rotation(const CameraView& view, const FrameSpace& space) {
  const glm::dmat3 rows(space.turned(view.right), space.turned(view.up), -space.turned(view.forward));
  return glm::mat4(glm::mat3(glm::transpose(rows)));
}

}  // namespace

const StageColours& stage_colours(bool by_day) { return by_day ? kDay : kDusk; }

StageColours stage_colours_from_below(bool by_day) {
  constexpr float kBrighter = 3;
  StageColours stage = stage_colours(by_day);
  stage.ground_light = {1.6f, 1.55f, 1.5f, 1};
  if (by_day) return stage;
  stage.sky_high *= kBrighter;
  stage.sky_low *= kBrighter;
  return stage;
}

double near_plane(const CameraView& view, const World::Bounds& drawn, double ground) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner(i & 1 ? drawn.max.x : drawn.min.x, i & 2 ? drawn.max.y : drawn.min.y,
                      i & 4 ? drawn.max.z : drawn.min.z);
    const double depth = glm::dot(corner - view.eye, view.forward);
    least = std::min(least, depth);
    most = std::max(most, std::abs(depth - view.focus));
  }
  if (view.parallel) return view.focus - (most + kParallelRoom * drawn.diagonal() + view.half_height());
  for (const double y : {-1.0, 1.0}) {
    const UpAxis up = view.up_axis;
    const double aside = view.aspect * std::abs(height_of(view.right, up));
    const double rise =
        height_of(view.forward, up) + view.tan_half_fov * (y * height_of(view.up, up) - aside);
    const double above = height_of(view.eye, up) - ground;
    if (rise < 0 && above > 0) least = std::min(least, -above / rise);
  }
  return std::max(kNear * view.focus, kRoom * least);
}

double window_depth(const CameraView& view, double near, double depth) {
  KERF_ASSERT(view.parallel || depth > 0);
  return view.parallel ? 0.5 * (depth - near) / (view.focus - near) : 1 - near / depth;
}

FrameUniforms uniforms_of(const CameraView& view, double near, const FrameSpace& space, int width,
                          int height) {
  KERF_ASSERT(space.unit > 0 && (view.parallel ? near < view.focus : near > 0));
  const CameraView close = view.near();
  FrameUniforms u;
  u.clip_from_frame = projection(view, near, space) * rotation(view, space);
  u.camera_right =
      glm::vec4(glm::vec3(space.turned(view.right)), static_cast<float>(close.tan_half_fov * view.aspect));
  u.camera_up = glm::vec4(glm::vec3(space.turned(view.up)), static_cast<float>(close.tan_half_fov));
  u.camera_forward = glm::vec4(glm::vec3(space.turned(view.forward)), space.length(view.focus - close.focus));
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  u.viewport = {w, h, 1 / w, 1 / h};
  return u;
}

namespace {
constexpr double kGapToGround =
    5e-4;  // gap between bodies and ground, in diagonals, which keeps flat parts visible
constexpr double kEarthGravity = 9.81;  // m/s^2
}  // namespace

double height_of_drawn_ground(const World& world, UpAxis up) {
  const Environment& around = world.environment();
  if (around.ground && around.up() == from_y_up({0, 1, 0}, up)) return *around.ground;
  const World::Bounds bounds = world.loaded_bounds();
  const double diagonal = bounds.diagonal() > 0 ? bounds.diagonal() : 1;
  return height_of(bounds.min, up) - kGapToGround * diagonal;
}

Environment default_environment(const World& world, const FileFrame& frame) {
  const Vec3 down = from_y_up({0, -1, 0}, frame.up);
  const double metre = 1 / metres_per_unit(frame.unit);
  return {kEarthGravity * metre * down, height_of_drawn_ground(world, frame.up), metre};
}

Environment fitting_environment(const World& world, const FileFrame& frame) {
  Environment around = world.environment();
  if (around.gravity == Vec3(0)) return around;
  if (!around.ground) return default_environment(world, frame);
  const double metre = 1 / metres_per_unit(frame.unit);
  if (around.metre == metre) return around;
  around.gravity *= metre / around.metre;
  around.metre = metre;
  return around;
}

}  // namespace kerf
