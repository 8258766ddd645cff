#pragma once

#include <string>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

class Fields;

void describe(Fields& f, Pose& pose);            // "origin" and "direction", a unit vector
void describe(Fields& f, Placement& placement);  // "position" and "orientation"
// "piece": [slot, generation, label].
void piece_field(Fields& f, PieceId& piece);

inline constexpr NumberField<Sheet> kThickness{
    "thickness", "thickness", &Sheet::thickness, {1e-9, 1e3, "m", true}, always_written(0.001)};
inline constexpr NumberField<Sheet> kDensity{
    "density", "density", &Sheet::density, {1e-3, 1e6, "kg/m^3", true}, always_written(7850)};

// The sheet in a command, with the constants of its material next to the others.
void describe(Fields& f, Sheet& sheet);

// The sheet in a scene, with the constants in "substance".
void scene_sheet_fields(Fields& f, Sheet& sheet);

// The message why a stroke left a solid body open, with the name of the body: "car: ...". `world` is the
// one after the step.
std::string left_open_text(const LeftOpen& open, const World& world);

}  // namespace kerf
