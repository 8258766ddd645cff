#include "core/walls/beam_pencil.h"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/base/assert.h"

namespace kerf {

namespace {

// Directions that differ by less are parallel: over the longest ranges, lines then deviate by a thousandth of
// the radius at most.
constexpr double kParallel = 1e-9;
// The largest distance of a line from the apex, relative to the radius.
constexpr double kAtApex = 1e-3;
// The least cosine of the angle between a direction and the middle one.
constexpr double kLeastCosine = 0.3;

template <typename Visit>
void for_each_pose(std::span<const BeamMove> moves, Visit visit) {
  for (const BeamMove& m : moves) {
    visit(m.from);
    visit(m.to);
  }
}

// The point with the least sum of squared distances from the lines.
Vec3 nearest_to_lines(std::span<const BeamMove> moves) {
  glm::dmat3 sum(0.0);
  Vec3 right(0);
  const Vec3 near = moves.front().from.origin;
  for_each_pose(moves, [&](const Pose& pose) {
    const glm::dmat3 across = glm::dmat3(1.0) - glm::outerProduct(pose.direction, pose.direction);
    sum += across;
    right += across * (pose.origin - near);
  });
  return near + glm::inverse(sum) * right;
}

}  // namespace

std::optional<BeamPencil> BeamPencil::of(std::span<const BeamMove> moves, double radius) {
  KERF_ASSERT(!moves.empty());
  BeamPencil pencil;
  const Vec3 first = moves.front().from.direction;
  Vec3 sum(0);
  pencil.parallel_ = true;
  pencil.origin_ = moves.front().from.origin;
  for_each_pose(moves, [&](const Pose& pose) {
    sum += pose.direction;
    pencil.parallel_ = pencil.parallel_ && glm::length(pose.direction - first) <= kParallel;
  });
  if (!(glm::length(sum) > 0)) return std::nullopt;
  pencil.axis_ = pencil.parallel_ ? first : glm::normalize(sum);
  pencil.right_ = across(pencil.axis_);
  pencil.up_ = glm::cross(pencil.axis_, pencil.right_);
  if (pencil.parallel_) return pencil;
  const Vec3 apex = nearest_to_lines(moves);
  bool meet = true;
  for_each_pose(moves, [&](const Pose& pose) {
    const Vec3 from = apex - pose.origin;
    const double distance = glm::length(from - glm::dot(from, pose.direction) * pose.direction);
    meet = meet && distance <= kAtApex * radius && glm::dot(pose.direction, pencil.axis_) > kLeastCosine;
  });
  if (!meet) return std::nullopt;
  pencil.origin_ = apex;
  return pencil;
}

BeamPencil::Seen BeamPencil::see(const Vec3& p) const {
  const Vec3 a = p - origin_;
  return {{glm::dot(a, right_), glm::dot(a, up_)}, glm::dot(a, axis_)};
}

Vec3 BeamPencil::point(Vec2 place, double depth) const {
  return origin_ + depth * axis_ + place.x * right_ + place.y * up_;
}

double BeamPencil::longest_ellipse(std::span<const BeamMove> moves) const {
  double longest = 1;
  for_each_pose(moves,
                [&](const Pose& pose) { longest = std::max(longest, 1 / glm::dot(pose.direction, axis_)); });
  return longest;
}

DiscMove BeamPencil::at_depth(const BeamMove& move, double depth) const {
  const auto centre = [&](const Pose& pose) {
    if (parallel_) return see(pose.origin).place;
    const Vec3 d = pose.direction * (depth / glm::dot(pose.direction, axis_));
    return Vec2(glm::dot(d, right_), glm::dot(d, up_));
  };
  return {centre(move.from), centre(move.to)};
}

}  // namespace kerf
