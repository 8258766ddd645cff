#include "ui/render/picture/beam_strike.h"

#include <cmath>

#include "core/cut/cuttable.h"

namespace kerf {

namespace {

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
  for (const BodyId id : cuttable(world)) {
    const Body& body = world.body(id);
    hits.clear();
    body.tree.crossings(body.mesh, body.placement.to_body(ray), {0, glm::length(far)}, hits);
    if (!hits.empty() && (!nearest || hits.front().length < *nearest)) nearest = hits.front().length;
  }
  return nearest;
}

std::optional<double> find_strike(const World& world, const Pose& beam, double radius, double overshoot,
                                  double reach) {
  std::optional<double> strike;
  const Vec3 u = any_perpendicular(beam.direction), w = glm::cross(beam.direction, u);
  for (const double aside : {0.0, kProbeRadius * radius, kProbeRadius * (radius + overshoot)}) {
    for (int i = 0; i < (aside > 0 ? kProbes : 1); ++i) {
      const double angle = 6.283185307179586 * i / kProbes;
      const Vec3 from = beam.origin + (u * std::cos(angle) + w * std::sin(angle)) * aside;
      const std::optional<double> hit = first_hit(world, {from, beam.direction});
      if (hit && *hit <= reach && (!strike || *hit < *strike)) strike = hit;
    }
  }
  return strike;
}

BeamPicture picture_of_beam(const World& world, const CutSettings& settings, const Pose& beam,
                            double length) {
  const double radius = settings.laser.radius, reach = settings.laser.range.high;
  const Vec3 end = beam.origin + beam.direction * std::min(reach, length);
  BeamPicture picture{beam.origin, end, std::nullopt, radius};
  const bool by_edge = settings.resolution.rule == Resolution::Rule::kTargetEdge;
  const double overshoot = by_edge ? settings.resolution.target_edge : 0.5 * radius;
  if (const auto strike = find_strike(world, beam, radius, overshoot, reach))
    picture.strike = beam.origin + beam.direction * *strike;
  return picture;
}

}  // namespace kerf
