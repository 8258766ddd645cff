#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/walls/beam_pencil_internal.h"

namespace kerf {

namespace {

// Directions that differ by less are parallel: over the longest ranges lines deviate by 1e-3 radii at most.
constexpr double kParallel = 1e-9;
// Max distance of a line from the apex, in radii.
constexpr double kAtApex = 1e-3;
// Min cosine of the angle between a direction and the normal of a surface.
constexpr double kMinCosine = 0.3;

template <typename Visit>
void for_each_pose(std::span<const BeamMove> moves, Visit visit) {
  for (const BeamMove& m : moves) {
    visit(m.from);
    visit(m.to);
  }
}

// Returns the point with the smallest sum of squared distances from the lines, those parallel to `axis` (unit
// or zero) not counted. Precondition: the lines are not all parallel, nor in planes across `axis` alone.
Vec3 nearest_to_lines(std::span<const BeamMove> moves, const Vec3& axis) {
  glm::dmat3 sum = glm::outerProduct(axis, axis);
  Vec3 right(0);
  const Vec3 near = moves.front().from.origin;
  for_each_pose(moves, [&](const Pose& pose) {
    const glm::dmat3 across =
        glm::dmat3(1.0) - glm::outerProduct(pose.direction, pose.direction) - glm::outerProduct(axis, axis);
    sum += across;
    right += across * (pose.origin - near);
  });
  return near + glm::inverse(sum) * right;
}

// Returns the unit vector most nearly perpendicular to all directions: that of the largest cross product with
// the first one; nullopt if they are not perpendicular to any.
std::optional<Vec3> common_perpendicular(std::span<const BeamMove> moves) {
  const Vec3 first = moves.front().from.direction;
  Vec3 widest(0);
  for_each_pose(moves, [&](const Pose& pose) {
    const Vec3 normal = glm::cross(first, pose.direction);
    if (glm::dot(normal, normal) > glm::dot(widest, widest)) widest = normal;
  });
  if (!(glm::length(widest) > kParallel)) return std::nullopt;
  const Vec3 axis = glm::normalize(widest);
  bool holds = true;
  for_each_pose(moves, [&](const Pose& pose) {
    holds = holds && std::abs(glm::dot(pose.direction, axis)) <= 1e3 * kParallel;
  });
  if (!holds) return std::nullopt;
  return axis;
}

}  // namespace

BeamPencil BeamPencil::across_middle(std::span<const BeamMove> moves) {
  BeamPencil pencil;
  Vec3 sum(0);
  for_each_pose(moves, [&](const Pose& pose) { sum += pose.direction; });
  pencil.origin_ = moves.front().from.origin;
  pencil.axis_ = glm::length(sum) > 0 ? glm::normalize(sum) : moves.front().from.direction;
  pencil.right_ = across(pencil.axis_);
  pencil.up_ = glm::cross(pencil.axis_, pencil.right_);
  return pencil;
}

std::vector<BeamPencil> BeamPencil::all_of(std::span<const BeamMove> moves, double radius) {
  KERF_ASSERT(!moves.empty());
  if (const auto pencil = parallel(moves)) return {*pencil};
  std::vector<BeamPencil> all;
  for (const auto& pencil : {through_apex(moves, radius), turning(moves), ruled(moves)}) {
    if (pencil) all.push_back(*pencil);
  }
  return all;
}

std::optional<BeamPencil> BeamPencil::parallel(std::span<const BeamMove> moves) {
  const Vec3 first = moves.front().from.direction;
  bool holds = true;
  for_each_pose(moves,
                [&](const Pose& pose) { holds = holds && glm::length(pose.direction - first) <= kParallel; });
  if (!holds) return std::nullopt;
  BeamPencil pencil = across_middle(moves);
  pencil.axis_ = first;
  pencil.right_ = across(pencil.axis_);
  pencil.up_ = glm::cross(pencil.axis_, pencil.right_);
  return pencil;
}

std::optional<BeamPencil> BeamPencil::through_apex(std::span<const BeamMove> moves, double radius) {
  BeamPencil pencil = across_middle(moves);
  pencil.kind_ = Kind::kApex;
  pencil.origin_ = nearest_to_lines(moves, Vec3(0));
  bool meet = true;
  for_each_pose(moves, [&](const Pose& pose) {
    const Vec3 from = pencil.origin_ - pose.origin;
    const double distance = glm::length(from - glm::dot(from, pose.direction) * pose.direction);
    meet = meet && distance <= kAtApex * radius && glm::dot(pose.direction, pencil.axis_) > kMinCosine;
  });
  if (!meet) return std::nullopt;
  return pencil;
}

std::optional<BeamPencil> BeamPencil::turning(std::span<const BeamMove> moves) {
  const auto axis = common_perpendicular(moves);
  if (!axis) return std::nullopt;
  BeamPencil pencil = across_middle(moves);
  pencil.kind_ = Kind::kTurning;
  pencil.right_ = -pencil.axis_ + glm::dot(pencil.axis_, *axis) * *axis;
  pencil.right_ = glm::normalize(pencil.right_);
  pencil.axis_ = *axis;
  pencil.up_ = glm::cross(*axis, pencil.right_);
  pencil.origin_ = nearest_to_lines(moves, *axis);
  return pencil;
}

std::optional<BeamPencil> BeamPencil::ruled(std::span<const BeamMove> moves) {
  BeamPencil pencil = across_middle(moves);
  pencil.kind_ = Kind::kRuled;
  bool steep = true;
  for_each_pose(
      moves, [&](const Pose& pose) { steep = steep && glm::dot(pose.direction, pencil.axis_) > kMinCosine; });
  if (!steep) return std::nullopt;
  return pencil;
}

BeamPencil::Seen BeamPencil::see(const Vec3& p) const {
  const Vec3 a = p - origin_;
  const Vec2 flat{glm::dot(a, right_), glm::dot(a, up_)};
  if (kind_ != Kind::kTurning) return {flat, glm::dot(a, axis_)};
  const double radius = glm::length(flat);
  return {{glm::dot(a, axis_), radius * det::atan2(flat.y, flat.x)}, -radius};
}

Vec3 BeamPencil::point(Vec2 place, double depth) const {
  if (kind_ != Kind::kTurning) return origin_ + depth * axis_ + place.x * right_ + place.y * up_;
  const auto [sin, cos] = sin_cos(place.y / -depth);
  return origin_ + place.x * axis_ - depth * (cos * right_ + sin * up_);
}

double BeamPencil::around(double depth) const { return kind_ == Kind::kTurning ? -2 * kPi * depth : 0; }

// Returns the signed distance of a line from the axis of turning beams.
double BeamPencil::offset(const Pose& pose) const {
  const Vec3 from = pose.origin - origin_;
  return glm::dot(glm::cross(from, pose.direction), axis_);
}

std::vector<BeamPencil::Hit> BeamPencil::hits(std::span<const BeamMove> moves, Interval range,
                                              double depth) const {
  std::vector<Hit> hits;
  for (const bool leaves : {false, true}) {
    if (leaves && kind_ != Kind::kTurning) break;
    for (uint32_t i = 0; i < moves.size(); ++i) {
      const auto is_within = [&](const Pose& pose) {
        const double h = offset(pose), half2 = depth * depth - h * h;
        if (!(half2 > 0)) return false;
        const double middle = glm::dot(origin_ - pose.origin, pose.direction);
        const double at = middle + (leaves ? 1 : -1) * std::sqrt(half2);
        return range.low <= at && at <= range.high;
      };
      if (kind_ != Kind::kTurning || is_within(moves[i].from) || is_within(moves[i].to))
        hits.push_back({i, leaves});
    }
  }
  return hits;
}

// Returns the place at which an axis of the beam crosses the surface at a depth.
std::optional<Vec2> BeamPencil::centre(const Pose& pose, bool leaves, double depth) const {
  const Vec3& d = pose.direction;
  if (kind_ == Kind::kParallel) return see(pose.origin).place;
  if (kind_ == Kind::kApex) {
    const Vec3 way = d * (depth / glm::dot(d, axis_));
    return Vec2(glm::dot(way, right_), glm::dot(way, up_));
  }
  if (kind_ == Kind::kRuled) {
    const Vec3 from = pose.origin - origin_;
    const Vec3 at = from + d * ((depth - glm::dot(from, axis_)) / glm::dot(d, axis_));
    return Vec2(glm::dot(at, right_), glm::dot(at, up_));
  }
  const double h = offset(pose), half2 = depth * depth - h * h;
  if (!(half2 > kMinCosine * kMinCosine * depth * depth)) return std::nullopt;
  const double middle = glm::dot(origin_ - pose.origin, d);
  return see(pose.origin + (middle + (leaves ? 1 : -1) * std::sqrt(half2)) * d).place;
}

std::optional<std::vector<DiscMove>> BeamPencil::at_depth(std::span<const BeamMove> moves,
                                                          std::span<const Hit> hits, double depth) const {
  std::vector<DiscMove> discs;
  const double turn = around(depth);
  const auto continued = [&](Vec2 place, double from) {
    if (turn > 0) place.y += turn * std::round((from - place.y) / turn);
    return place;
  };
  for (const Hit& hit : hits) {
    const auto from = centre(moves[hit.move].from, hit.leaves, depth),
               to = centre(moves[hit.move].to, hit.leaves, depth);
    if (!from || !to) return std::nullopt;
    const Vec2 begin = continued(*from, discs.empty() ? from->y : discs.back().to.y);
    discs.push_back({begin, continued(*to, begin.y)});
  }
  return discs;
}

double BeamPencil::longest_ellipse(std::span<const BeamMove> moves, double depth) const {
  double longest = 1;
  for_each_pose(moves, [&](const Pose& pose) {
    const double sine = kind_ == Kind::kTurning ? offset(pose) / depth : 0;
    const double cosine = kind_ == Kind::kTurning
                              ? std::sqrt(std::max(1 - sine * sine, kMinCosine * kMinCosine))
                              : glm::dot(pose.direction, axis_);
    longest = std::max(longest, 1 / cosine);
  });
  return longest;
}

}  // namespace kerf
