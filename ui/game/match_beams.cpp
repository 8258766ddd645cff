#include "ui/game/match_beams.h"

#include "core/base/assert.h"

namespace kerf {

std::optional<BeamPicture> beam_of(const Match& match, size_t vehicle, const Sight& sight) {
  KERF_ASSERT(vehicle < match.vehicles().size());
  const Vehicle& v = match.vehicles()[vehicle];
  if (!v.gun.firing || !v.gun.last) return std::nullopt;
  const Pose& pose = *v.gun.last;
  BeamPicture beam{pose.origin, pose.origin + pose.direction * v.gun.length, std::nullopt, v.gun.radius};
  const auto hit = sight.nearest(pose, v.gun.length * (1 + 1e-6), [&](BodyId id) { return !v.has(id); });
  if (hit) beam.strike = pose.origin + pose.direction * hit->length;
  beam.on_ground = hit && !hit->body.valid();
  return beam;
}

}  // namespace kerf
