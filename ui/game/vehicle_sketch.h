#pragma once

#include "core/game/vehicle/vehicle.h"
#include "ui/game/hud_paint.h"

namespace kerf {

// Draws a vehicle from above in a rectangle that is `height` high around `middle`: its outline, wheels,
// laser, engine and driver. What is lost is crossed out.
void draw_vehicle_sketch(const Vehicle& vehicle, const HudPaint& paint, ImVec2 middle, float height);

}  // namespace kerf
