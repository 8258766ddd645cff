#include "ui/editor/laser_tool.h"

#include <cmath>
#include <vector>

namespace kerf {

namespace {

constexpr double kEmitterAside = 0.06;  // of the focus, to the right and up
constexpr double kLeastMove = 0.5;      // pixels
constexpr int kProbes = 8;  // rays on each circle around the beam that look for the rim of what it burns
constexpr double kProbeRadius = 1.05;  // radii

Vec3 any_perpendicular(const Vec3& d) {
  const Vec3 other = std::abs(d.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  return glm::normalize(glm::cross(d, other));
}

}  // namespace

std::optional<double> first_hit(const World& world, const Pose& ray) {
  std::optional<double> nearest;
  std::vector<RayHit> hits;
  const World::Bounds bounds = world.bounds();
  const Vec3 far = glm::max(glm::abs(bounds.min - ray.origin), glm::abs(bounds.max - ray.origin));
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    hits.clear();
    body.tree.crossings(body.mesh, body.placement.to_body(ray), {0, glm::length(far)}, hits);
    if (!hits.empty() && (!nearest || hits.front().length < *nearest)) nearest = hits.front().length;
  }
  return nearest;
}

Pose LaserTool::aim(const CameraView& view, Vec2 pointer) const {
  const Pose ray = view.ray(pointer.x, pointer.y);
  const Vec3 emitter = view.eye + (view.right + view.up) * (kEmitterAside * focus_);
  return {emitter, glm::normalize(ray.origin + ray.direction * focus_ - emitter)};
}

void LaserTool::press(Document& document, const CameraView& view, Vec2 pointer,
                      const LaserControls& controls) {
  const Pose ray = view.ray(pointer.x, pointer.y);
  focus_ = first_hit(document.world(), ray).value_or(view.focus);
  const CutSettings settings = controls.settings(document.world().bounds().diagonal());
  radius_ = settings.laser.radius;
  const bool by_edge = settings.resolution.rule == Resolution::Rule::kTargetEdge;
  overshoot_ = by_edge ? settings.resolution.target_edge : 0.5 * radius_;
  reach_ = settings.laser.range.high;
  pointer_ = pointer;
  pose_ = aim(view, pointer);
  beam_ = pose_;
  strike_.reset();
  cutting_ = true;
  document.apply(BeginStroke{settings, pose_});
}

void LaserTool::move(Document& document, const CameraView& view, Vec2 pointer, double pixel) {
  if (!cutting_) return;
  const Vec2 moved = (pointer - pointer_) * Vec2(view.aspect, 1) / pixel;
  if (glm::length(moved) < kLeastMove) return;
  pointer_ = pointer;
  pose_ = aim(view, pointer);
  document.apply(MoveStroke{pose_});
}

void LaserTool::release(Document& document) {
  if (!cutting_) return;
  cutting_ = false;
  document.apply(EndStroke{});
}

void LaserTool::find_strike(const Document& document) {
  strike_.reset();
  if (const BeamMove* move = document.next_move()) beam_ = move->to;
  const Vec3 u = any_perpendicular(beam_.direction), w = glm::cross(beam_.direction, u);
  for (const double aside : {0.0, kProbeRadius * radius_, kProbeRadius * (radius_ + overshoot_)}) {
    for (int i = 0; i < (aside > 0 ? kProbes : 1); ++i) {
      const double angle = 6.283185307179586 * i / kProbes;
      const Vec3 from = beam_.origin + (u * std::cos(angle) + w * std::sin(angle)) * aside;
      const std::optional<double> hit = first_hit(document.world(), {from, beam_.direction});
      if (hit && *hit <= reach_ && (!strike_ || *hit < *strike_)) strike_ = hit;
    }
  }
}

std::optional<BeamPicture> LaserTool::picture(const Document& document) const {
  if (!cutting_ && document.waiting() == 0) return std::nullopt;
  BeamPicture beam{beam_.origin, beam_.origin + beam_.direction * std::min(reach_, 20 * focus_), std::nullopt,
                   radius_};
  if (strike_) beam.strike = beam_.origin + beam_.direction * *strike_;
  return beam;
}

}  // namespace kerf
