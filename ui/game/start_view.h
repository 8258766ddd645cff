#pragma once

#include "core/game/match/match.h"
#include "ui/render/view/camera.h"

namespace kerf {

// The view behind the menu before a match: the player's car from ahead, near the ground, at the right of the
// picture; it swings to and fro. `seconds` is for how long it is shown, `field_of_view` is vertical, in
// degrees.
CameraView start_view(const Match& match, double seconds, double aspect, double field_of_view);

}  // namespace kerf
