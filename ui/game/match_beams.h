#pragma once

#include <optional>
#include <vector>

#include "core/game/match/match.h"
#include "ui/render/passes/effects.h"

namespace kerf {

// The beam of a vehicle as it is drawn, up to the wall or the ground where it ends; nothing if it is off.
// `strike` is the first surface that it meets, be it cut or not. Precondition: the match has this
// vehicle.
std::optional<BeamPicture> beam_of(const Match& match, size_t vehicle, const Sight& sight);

}  // namespace kerf
