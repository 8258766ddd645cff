#include "ui/editor/path/drawing_placement.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "ui/render/passes/beam_effects.h"

namespace kerf {

namespace {

constexpr double kMinSine = 1e-3;  // of the angle between a direction and the normal of its plane

// Returns the unit vector of the plane with this normal that points upwards in a view.
Vec3 up_in_plane(const Vec3& normal, const CameraView& view) {
  for (const Vec3& way : {view.up, view.forward, view.right}) {
    const Vec3 in_plane = way - glm::dot(way, normal) * normal;
    if (glm::length(in_plane) > kMinSine) return glm::normalize(in_plane);
  }
  return view.up;
}

JobPlane facing(const Vec3& at, const Vec3& normal, const Vec3& up) {
  JobPlane plane;
  plane.at = at;
  plane.up = up;
  plane.beam = -normal;
  plane.right = glm::cross(up, normal);
  return plane;
}

Vec3 axis_vector(int axis) { return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0}; }

// The cylinder around an axis of the world through the middle of the bounds.
JobPlane wrapped(const DrawingPlacement& placement, const Bounds& bounds) {
  Vec3 axis = axis_vector(placement.axis);
  if (glm::dot(axis, placement.view.up) < 0) axis = -axis;
  const Vec3 from = placement.anchor.at - bounds.centre();
  const double along = glm::dot(from, axis);
  Vec3 outward = from - along * axis;
  const double distance = glm::length(outward), least = kMinSine * bounds.diagonal();
  outward = distance > least ? outward / distance : up_in_plane(axis, placement.view);
  const double radius = std::max(placement.radius.value_or(distance), std::max(least, 1e-9));
  JobPlane plane = facing(bounds.centre() + along * axis + radius * outward, outward, axis);
  plane.wrap = radius;
  return plane;
}

// Moves a plane against the beam to a tenth of the diagonal outside the bounds.
void move_outside(JobPlane& plane, const Bounds& bounds) {
  const Vec3 half = 0.5 * bounds.max - 0.5 * bounds.min;
  const double top = glm::dot(bounds.centre() - plane.at, -plane.beam) + glm::dot(half, glm::abs(plane.beam));
  plane.at -= std::max(0.0, top + 0.1 * bounds.diagonal()) * plane.beam;
}

struct PlacedBeam {
  Pose beam;
  Vec3 on_plane{0};
  std::optional<double> hit;  // m along the beam
  Vec3 target() const { return hit ? beam.origin + *hit * beam.direction : on_plane; }
};

// Returns true if the surface between two beams next to each other is not continuous.
bool breaks(const PlacedBeam& a, const PlacedBeam& b) {
  constexpr double kSteepest = 8;  // depth over width
  if (a.hit.has_value() != b.hit.has_value()) return true;
  const Vec3 step = b.target() - a.target();
  const double depth = glm::dot(step, a.beam.direction);
  return std::abs(depth) > kSteepest * glm::length(step - depth * a.beam.direction);
}

Vec2 turned(Vec2 p, double angle) {
  const auto [sin, cos] = sin_cos(angle);
  return {cos * p.x - sin * p.y, sin * p.x + cos * p.y};
}

// Returns the distance along a ray at which it enters the cylinder of a wrapped plane.
std::optional<double> enters_cylinder(const JobPlane& plane, const Pose& ray) {
  const auto across = [&](const Vec3& v) { return Vec2(glm::dot(v, plane.right), glm::dot(v, plane.beam)); };
  const Vec2 from = across(ray.origin - plane.at) - Vec2(0, plane.wrap), way = across(ray.direction);
  const double a = glm::dot(way, way), b = glm::dot(from, way);
  const double inside = b * b - a * (glm::dot(from, from) - plane.wrap * plane.wrap);
  if (!(a > 0) || inside < 0) return std::nullopt;
  const double distance = (-b - std::sqrt(inside)) / a;
  return distance > 0 ? std::optional(distance) : std::nullopt;
}

// Returns the distance of a point from the origin of the beam through it, of a stroke with this first key.
double depth_of(const JobPlane& plane, const Pose& first, const Vec3& p) {
  if (plane.eye) return glm::length(p - *plane.eye);
  if (plane.wrap == 0) return glm::dot(p - first.origin, first.direction);
  const Vec3 from = p - (plane.at + plane.wrap * plane.beam);
  return 2 * plane.wrap - glm::length(from - glm::dot(from, plane.up) * plane.up);
}

}  // namespace

JobPlane DrawingPlacement::plane(const Bounds& bounds) const {
  JobPlane plane;
  switch (mode) {
    case DrawingMode::kPlane:
      plane = facing(anchor.at, anchor.normal, up_in_plane(anchor.normal, view));
      break;
    case DrawingMode::kAxis:
      plane = *plane_onto(kBeamAxes.at(static_cast<size_t>(beam)));
      plane.at = anchor.at;
      break;
    case DrawingMode::kView:
      plane = facing(anchor.at, -view.forward, view.up);
      if (!view.parallel) plane.eye = view.eye;
      break;
    case DrawingMode::kWrap:
      plane = wrapped(*this, bounds);
      break;
  }
  plane.turn = turn;
  plane.scale = scale;
  return plane;
}

JobPlane DrawingPlacement::start(const Bounds& bounds, double extent) const {
  JobPlane from = plane(bounds);
  if (mode == DrawingMode::kPlane) from.at -= 0.5 * extent * from.beam;
  if (mode == DrawingMode::kAxis || (mode == DrawingMode::kView && !from.eye)) move_outside(from, bounds);
  return from;
}

Vec3 point_on(const JobPlane& plane, Vec2 p) {
  if (plane.wrap == 0) return plane.point(p, 0);
  const Pose beam = plane.wrapped_beam(p);
  return beam.origin + plane.wrap * beam.direction;
}

std::optional<Vec2> drawing_point(const JobPlane& plane, const Pose& ray) {
  Vec2 q;
  if (plane.wrap > 0) {
    const auto distance = enters_cylinder(plane, ray);
    if (!distance) return std::nullopt;
    const Vec3 from = ray.origin + *distance * ray.direction - (plane.at + plane.wrap * plane.beam);
    q = {plane.wrap * std::atan2(glm::dot(from, plane.right), -glm::dot(from, plane.beam)),
         glm::dot(from, plane.up)};
  } else {
    const double cosine = glm::dot(ray.direction, plane.beam);
    const double distance = glm::dot(plane.at - ray.origin, plane.beam) / cosine;
    if (!(std::abs(cosine) > kMinSine) || !(distance > 0)) return std::nullopt;
    const Vec3 from = ray.origin + distance * ray.direction - plane.at;
    q = {glm::dot(from, plane.right), glm::dot(from, plane.up)};
  }
  return turned(q / plane.scale, -plane.turn);
}

std::vector<ProjectedLine> project_lines(std::span<const DrawnLine> lines, Vec2 middle, double extent,
                                         const DrawingPlacement& placement, const World& world) {
  constexpr double kSteps = 256;  // per extent
  const Bounds bounds = world.bounds();
  const JobPlane plane = placement.plane(bounds), start = placement.start(bounds, placement.scale * extent);
  double length = 0;
  const auto corner = [](const DrawnLine& line, size_t i) { return line.points[i % line.points.size()]; };
  const auto corners = [](const DrawnLine& line) { return line.points.size() + (line.closed ? 1 : 0); };
  for (const DrawnLine& line : lines) {
    for (size_t i = 1; i < corners(line); ++i) length += glm::length(corner(line, i) - corner(line, i - 1));
  }
  const double step = std::max(extent / kSteps, length / (0.5 * kMaxProjected));
  std::vector<ProjectedLine> all;
  for (size_t k = 0; k < lines.size(); ++k) {
    std::optional<PlacedBeam> before;
    const auto add = [&](Vec2 p) {
      PlacedBeam here{start.beam_to(p - middle), point_on(plane, p - middle), {}};
      here.hit = first_hit(world, here.beam);
      if (!before || breaks(*before, here)) all.push_back({k, here.hit.has_value(), {}});
      all.back().points.push_back(here.target());
      before = here;
    };
    add(lines[k].points.front());
    for (size_t i = 1; i < corners(lines[k]); ++i) {
      const Vec2 from = corner(lines[k], i - 1), to = corner(lines[k], i);
      const auto parts = static_cast<size_t>(std::clamp(std::ceil(glm::length(to - from) / step), 1.0, 1e6));
      for (size_t part = 1; part <= parts; ++part)
        add(glm::mix(from, to, static_cast<double>(part) / static_cast<double>(parts)));
    }
  }
  return all;
}

void end_behind_surface(std::span<const DrawnLine> lines, Vec2 middle, double extent,
                        const DrawingPlacement& placement, const World& world,
                        std::span<StrokePath> strokes) {
  KERF_ASSERT(lines.size() == strokes.size());
  constexpr double kMargin = 1e-3;  // of the diagonal of the world
  const Bounds bounds = world.bounds();
  const JobPlane plane = placement.plane(bounds);
  for (size_t i = 0; i < strokes.size(); ++i) {
    double depth = 0;
    for (const ProjectedLine& part : project_lines(lines.subspan(i, 1), middle, extent, placement, world)) {
      if (!part.on_surface) continue;
      for (const Vec3& p : part.points) depth = std::max(depth, depth_of(plane, strokes[i].keys.front(), p));
    }
    strokes[i].range = Interval{0, depth + kMargin * bounds.diagonal()};
  }
}

std::vector<DrawingHandle> drawing_handles(const PrimaryViewport& picture, const JobPlane& plane, Vec2 half) {
  constexpr double kKnobEms = 2;
  constexpr std::array<Vec2, 4> kCorners{Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)};
  std::vector<DrawingHandle> handles;
  if (!picture.place_of(plane.at)) return handles;
  const double above = kKnobEms * picture.metres_of_em(plane.at) / plane.scale;
  handles.push_back(
      {{picture, "drawing turn", {point_on(plane, {0, half.y + above})}}, DrawingHandle::Kind::kTurn});
  for (size_t i = 0; i < kCorners.size(); ++i) {
    handles.push_back(
        {{picture, "drawing corner " + std::to_string(i), {point_on(plane, kCorners[i] * half)}},
         DrawingHandle::Kind::kSize});
  }
  return handles;
}

std::vector<Vec2> drawing_frame(const PrimaryViewport& picture, const JobPlane& plane, Vec2 half) {
  constexpr std::array<Vec2, 5> kCorners{Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1)};
  const int parts = plane.wrap > 0 ? 24 : 1;
  std::vector<Vec2> frame;
  for (size_t i = 0; i + 1 < kCorners.size(); ++i) {
    for (int part = 0; part < parts; ++part) {
      const double share = static_cast<double>(part) / parts;
      const auto place =
          picture.place_of(point_on(plane, half * glm::mix(kCorners[i], kCorners[i + 1], share)));
      if (!place) return {};
      frame.push_back(*place);
    }
  }
  return frame;
}

}  // namespace kerf
