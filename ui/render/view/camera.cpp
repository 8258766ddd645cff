#include "ui/render/view/camera.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kPole = 1.5533;        // 89 degrees
constexpr double kDefaultYaw = 0.66;    // 38 degrees to the right of the front
constexpr double kDefaultPitch = 0.30;  // 17 degrees
constexpr double kEaseSeconds = 0.043;  // to 1/e; nine tenths in 100 ms, 97 % in 150 ms
constexpr double kNarrow = 1.25;        // a narrower frame shows the same width, and more above and below
constexpr double kMaxWidth = 0.82;      // of the frame that a framed box may take
constexpr double kTurn = 6.283185307179586;
const double kFullPull = std::log(CameraView::kFarAway);

// The x and y span of the box in the frame; `in_front`: all of it is in front of the eye.
struct Extent {
  Vec2 low{1e300}, high{-1e300};
  bool in_front = true;
};

Extent extent_of(const CameraView& view, const World::Bounds& b) {
  Extent extent;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = view.project(
        {corner & 1 ? b.max.x : b.min.x, corner & 2 ? b.max.y : b.min.y, corner & 4 ? b.max.z : b.min.z});
    extent.in_front = extent.in_front && p.z > 0;
    extent.low = glm::min(extent.low, Vec2(p));
    extent.high = glm::max(extent.high, Vec2(p));
  }
  return extent;
}

constexpr double kMinDepth = 1e-4;  // of the focus: minimum depth for projection

// x and y span the frame from -depth to depth.
struct ClipPoint {
  double x, y, depth;
};

ClipPoint clip_point(const CameraView& view, const Vec3& p) {
  const Vec3 d = p - view.eye;
  return {glm::dot(d, view.right) / (view.tan_half_fov * view.aspect),
          glm::dot(d, view.up) / view.tan_half_fov, view.parallel ? view.focus : glm::dot(d, view.forward)};
}

// Clips the fractions of a segment to the range in which a quantity linear along it is not negative.
void keep_positive(double at_from, double at_to, Vec2& share) {
  if (at_from < 0 && at_to < 0) share.y = -1;
  if (at_from < 0 && at_to >= 0) share.x = std::max(share.x, at_from / (at_from - at_to));
  if (at_from >= 0 && at_to < 0) share.y = std::min(share.y, at_from / (at_from - at_to));
}

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
constexpr double kGapToGround =
    5e-4;  // gap between bodies and ground, in diagonals, which keeps flat parts visible
constexpr double kEarthGravity = 9.81;  // m/s^2

}  // namespace

Pose CameraView::ray(double x, double y) const {
  if (parallel) return {eye + (right * (x * aspect) + up * y) * half_height(), forward};
  const Vec3 way = forward + right * (x * tan_half_fov * aspect) + up * (y * tan_half_fov);
  return {eye, glm::normalize(way)};
}

Vec3 CameraView::project(const Vec3& p) const {
  const Vec3 d = p - eye;
  const double depth = glm::dot(d, forward);
  const double scale = 1 / ((parallel ? focus : depth) * tan_half_fov);
  return {glm::dot(d, right) * scale / aspect, glm::dot(d, up) * scale, depth};
}

CameraView CameraView::near() const { return pulled(1); }

CameraView CameraView::pulled(double times) const {
  KERF_ASSERT(times > 0 && pull > 0);
  const double more = times / pull;
  CameraView view = *this;
  view.eye += forward * (focus - focus * more);
  view.focus = focus * more;
  view.tan_half_fov = tan_half_fov / more;
  view.parallel = times >= kFarAway;
  view.pull = times;
  return view;
}

CameraView look_at(const Vec3& eye, const Vec3& target, double aspect) {
  KERF_ASSERT(aspect > 0);
  CameraView view;
  view.eye = eye;
  view.aspect = aspect;
  view.tan_half_fov = Camera::kTanHalfFov;
  view.focus = glm::length(target - eye);
  if (!(view.focus > 0)) {
    view.focus = 1;
    return view;
  }
  view.forward = (target - eye) / view.focus;
  const Vec3 level(-view.forward.z, 0, view.forward.x);  // forward x up
  const double flat = glm::length(level);
  view.right = flat > 1e-9 ? level / flat : Vec3(1, 0, 0);
  view.up = glm::cross(view.right, view.forward);
  return view;
}

Vec3 Camera::direction_of(double yaw, double pitch) {
  return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
}

CameraView Camera::view_of(const State& s, double aspect) {
  const Vec3 outward = from_y_up(direction_of(s.yaw, s.pitch), s.up);
  CameraView view;
  view.eye = s.pivot + outward * s.distance;
  view.forward = -outward;
  view.right = from_y_up(Vec3(std::cos(s.yaw), 0, -std::sin(s.yaw)), s.up);
  view.up_axis = s.up;
  view.up = glm::cross(view.right, view.forward);
  view.focus = s.distance;
  view.tan_half_fov = kTanHalfFov * std::max(1.0, kNarrow / aspect);
  view.aspect = aspect;
  return s.pull == kFullPull ? view.pulled(CameraView::kFarAway) : view.pulled(std::exp(s.pull));
}

// Finds by bisection the distance at which the larger of the two spans fits, then moves the pivot so that
// the box is centred.
void Camera::fit(State& state, const World::Bounds& bounds, double aspect, double fill) {
  KERF_ASSERT(aspect > 0 && fill > 0);
  const double diagonal = bounds.diagonal();
  state.pivot = bounds.min + (bounds.max - bounds.min) * 0.5;
  if (!(diagonal > 0) || !std::isfinite(diagonal)) {
    state.distance = 1;
    return;
  }
  double near = 0.05 * diagonal, far = 50 * diagonal;
  for (int i = 0; i < 48; ++i) {
    state.distance = 0.5 * (near + far);
    const Extent e = extent_of(view_of(state, aspect), bounds);
    const bool fits = e.in_front && e.high.y - e.low.y <= 2 * fill && e.high.x - e.low.x <= 2 * kMaxWidth;
    (fits ? far : near) = state.distance;
  }
  state.distance = far;
  const CameraView view = view_of(state, aspect);
  const Extent e = extent_of(view, bounds);
  const Vec2 off = (e.low + e.high) * 0.5;
  state.pivot += (view.right * (off.x * aspect) + view.up * off.y) * view.half_height();
}

void Camera::frame_default(const World::Bounds& bounds, double aspect, double fill) {
  goal_.yaw = kDefaultYaw;
  goal_.pitch = kDefaultPitch;
  fit(goal_, bounds, aspect, fill);
}

void Camera::frame(const World::Bounds& bounds, double aspect, double fill) {
  fit(goal_, bounds, aspect, fill);
}

void Camera::look(const Vec3& eye, const Vec3& target) {
  const Vec3 outward = to_y_up(eye - target, goal_.up);
  const double distance = glm::length(outward);
  if (!(distance > 0)) return;
  goal_.pivot = target;
  goal_.distance = distance;
  goal_.yaw = std::atan2(outward.x, outward.z);
  goal_.pitch = std::clamp(std::asin(std::clamp(outward.y / distance, -1.0, 1.0)), -kPole, kPole);
}

void Camera::turn_to(double yaw, double pitch) {
  goal_.yaw += std::remainder(yaw - goal_.yaw, kTurn);
  goal_.pitch = pitch;
}

bool Camera::is_turned_to(double yaw, double pitch) const {
  constexpr double kSame = 1e-6;
  return std::abs(std::remainder(yaw - goal_.yaw, kTurn)) < kSame && std::abs(pitch - goal_.pitch) < kSame;
}

void Camera::set_parallel(bool parallel) { goal_.pull = parallel ? kFullPull : 0; }

void Camera::orbit(double right, double up) {
  goal_.yaw += right;
  goal_.pitch = std::clamp(goal_.pitch + up, -kPole, kPole);
}

void Camera::pan(double dx, double dy, double aspect) {
  const CameraView view = view_of(goal_, aspect);
  goal_.pivot -= (view.right * (dx * aspect) + view.up * dy) * view.half_height();
}

void Camera::zoom(double factor, double x, double y, double aspect) {
  const CameraView view = view_of(goal_, aspect);
  const Vec3 side = (view.right * (x * aspect) + view.up * y) * view.half_height();
  goal_.pivot += side * (1 - factor);
  goal_.distance *= factor;
}

bool Camera::advance(double seconds) {
  const double way = 1 - std::exp(-std::max(seconds, 0.0) / kEaseSeconds);
  const Vec3 shift = goal_.pivot - now_.pivot;
  const double ratio = goal_.distance / now_.distance;
  const double yaw = goal_.yaw - now_.yaw, pitch = goal_.pitch - now_.pitch, pull = goal_.pull - now_.pull;
  const double left = glm::length(shift) / goal_.distance + std::abs(std::log(ratio)) + std::abs(yaw) +
                      std::abs(pitch) + std::abs(pull);
  if (!(left > 2e-4)) {
    const bool moved = left > 0;
    now_ = goal_;
    return moved;
  }
  now_.pivot += shift * way;
  now_.distance *= std::pow(ratio, way);
  now_.yaw += yaw * way;
  now_.pitch += pitch * way;
  now_.pull += pull * way;
  return true;
}

std::optional<ScreenSegment> on_screen(const CameraView& view, const Vec3& from, const Vec3& to, int width,
                                       int height, double margin) {
  KERF_ASSERT(width > 0 && height > 0);
  const ClipPoint a = clip_point(view, from), b = clip_point(view, to);
  const Vec2 half(0.5 * width, 0.5 * height), limit = (half + margin) / half;
  const double least = kMinDepth * view.focus;
  Vec2 share(0, 1);
  keep_positive(a.depth - least, b.depth - least, share);
  keep_positive(limit.x * a.depth - a.x, limit.x * b.depth - b.x, share);
  keep_positive(limit.x * a.depth + a.x, limit.x * b.depth + b.x, share);
  keep_positive(limit.y * a.depth - a.y, limit.y * b.depth - b.y, share);
  keep_positive(limit.y * a.depth + a.y, limit.y * b.depth + b.y, share);
  if (!(share.x < share.y)) return std::nullopt;

  ScreenSegment seen;
  seen.share = share;
  const std::array<Vec2*, 2> ends{&seen.from, &seen.to};
  for (int i = 0; i < 2; ++i) {
    const double s = share[i], depth = std::max(a.depth + s * (b.depth - a.depth), least);
    const Vec2 at(a.x + s * (b.x - a.x), a.y + s * (b.y - a.y));
    *ends[i] = half + half * at / depth;
    seen.inverse_depth[i] = 1 / depth;
  }
  return seen;
}

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
  if (around.gravity != Vec3(0) && !around.ground) return default_environment(world, frame);
  const double metre = 1 / metres_per_unit(frame.unit);
  if (around.metre == metre) return around;
  around.gravity *= metre / around.metre;
  around.metre = metre;
  return around;
}

}  // namespace kerf
