#include "ui/editor/single_step/mark_stage.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/angle.h"

namespace kerf {

namespace {

using Kind = StageMarks::Kind;
using OfBody = StageMarks::OfBody;

constexpr int kCornersOfEnd = 12;  // of each half of the outline of the beam's end
constexpr double kBeyond =
    0.12;  // of the size of the body, by which the drawn volume is longer than the body

void outline(const Triangle& t, uint32_t piece, Kind kind, OfBody& marks) {
  for (size_t i = 0; i < 3; ++i) marks.lines.push_back({t[i], t[(i + 1) % 3], piece, kind});
}

void mark_face(const Triangle& t, uint32_t piece, Kind kind, OfBody& marks) {
  marks.fills.push_back({t, piece, kind});
  outline(t, piece, kind, marks);
}

// How deep along the beam the body lies: the part of the volume that is drawn.
Interval depths_of(const Body& body, const SweptCylinder::Slab& whole) {
  const Bounds box = body.bounds();
  Interval depths{INFINITY, -INFINITY};
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3 corner(i & 1u ? box.max.x : box.min.x, i & 2u ? box.max.y : box.min.y,
                      i & 4u ? box.max.z : box.min.z);
    const double depth = glm::dot(corner - whole.origin, whole.axis);
    depths = {std::min(depths.low, depth), std::max(depths.high, depth)};
  }
  const double beyond = kBeyond * glm::length(box.max - box.min);
  return {std::max(depths.low - beyond, whole.depth.low), std::min(depths.high + beyond, whole.depth.high)};
}

// The cross-section of the volume: two half circles around the ends of the motion of the axis.
std::vector<Vec3> section(const SweptCylinder::Slab& slab, double radius) {
  std::vector<Vec3> corners;
  for (const bool back : {false, true}) {
    const double end = back ? slab.motion.low + radius : slab.motion.high - radius;
    for (int i = 0; i <= kCornersOfEnd; ++i) {
      const double turn = kPi * (static_cast<double>(i) / kCornersOfEnd - 0.5) + (back ? kPi : 0);
      corners.push_back(slab.origin + slab.along * (end + radius * std::cos(turn)) +
                        slab.across * (radius * std::sin(turn)));
    }
  }
  return corners;
}

void mark_volume(const Body& body, const SweptCylinder& volume, OfBody& marks) {
  const SweptCylinder::Slab whole = volume.slab({-INFINITY, INFINITY});
  const Interval depths = depths_of(body, whole);
  if (!(depths.low < depths.high)) return;
  const SweptCylinder::Slab slab = volume.slab(depths);
  const std::vector<Vec3> around = section(slab, volume.radius());
  const Vec3 low = whole.axis * depths.low, high = whole.axis * depths.high;
  for (size_t i = 0; i < around.size(); ++i) {
    const Vec3 &a = around[i], &b = around[(i + 1) % around.size()];
    marks.lines.push_back({a + low, b + low, 0, Kind::kSwept});
    marks.lines.push_back({a + high, b + high, 0, Kind::kSwept});
    if (i % kCornersOfEnd == 0) marks.lines.push_back({a + low, a + high, 0, Kind::kSwept});
    marks.fills.push_back({{a + low, b + low, b + high}, 0, Kind::kSwept});
    marks.fills.push_back({{a + low, b + high, a + high}, 0, Kind::kSwept});
  }
}

void mark_delta(const World& world, const BodyDelta& delta, StageRecord::Kind stage, StageMarks& marks) {
  if (!world.contains(delta.body)) return;
  const Body& body = world.body(delta.body);
  OfBody& on = marks.bodies.emplace_back();
  on.body = delta.body;
  for (const CutFace& f : delta.removed) mark_face(f.corners, f.piece, Kind::kRemoved, on);
  const bool splits = stage == StageRecord::Kind::kRefine || stage == StageRecord::Kind::kCloseRim;
  if (splits) {
    for (const FaceId f : delta.born) outline(body.mesh.triangle(f), body.label(f), Kind::kBorn, on);
  }
  std::set<uint32_t> off(delta.new_pieces.begin(), delta.new_pieces.end());
  for (const FaceId f : delta.relabelled) off.insert(body.mesh.data(f).piece);
  for (const uint32_t label : off) marks.came_off.push_back({delta.body, label});
}

void mark_beam(const Body& body, const StageRecord& stage, OfBody& on) {
  for (const SweptCylinder& volume : stage.beam) mark_volume(body, volume, on);
  for (const FaceId f : stage.hit) mark_face(body.mesh.triangle(f), body.label(f), Kind::kHit, on);
}

}  // namespace

StageMarks mark_stage(const World& world, const StageRecord& stage) {
  StageMarks marks;
  if (world.contains(stage.body)) {
    OfBody& on = marks.bodies.emplace_back();
    on.body = stage.body;
    mark_beam(world.body(stage.body), stage, on);
  }
  for (const BodyDelta& delta : stage.done.delta.bodies) mark_delta(world, delta, stage.kind, marks);
  return marks;
}

}  // namespace kerf
