#pragma once

#include <optional>
#include <string>

#include "core/game/match/match.h"

namespace kerf {

// The part of an enemy that is not out yet, which a beam of the player would meet first.
struct SightedPart {
  size_t vehicle = 0;  // an index of Match::vehicles()
  BodyId body;
  Vec3 at{0};        // m, where the beam would meet it
  std::string name;  // "front left wheel", "engine"
};

// The part in a direction (unit vector) from the player's laser, within its range. `sight` must be of the
// world of the match, as it is. Nothing where the beam would meet no enemy first.
std::optional<SightedPart> sighted_part(const Match& match, const Sight& sight, const Vec3& aim);

// Where a beam of the player along `aim` (unit) would end, or meet something first; m, in the world.
Vec3 place_aimed_at(const Match& match, const Sight& sight, const Vec3& aim);

// Whether no wall stands between a point and a vehicle.
bool sees_vehicle(const Match& match, const Sight& sight, const Vec3& from, size_t vehicle);

}  // namespace kerf
