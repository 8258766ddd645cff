#pragma once

#include "core/base/tick.h"
#include "core/world/world.h"

namespace kerf {

// Lets heat flow in all bodies, and be lost from them, for a time (s, >= 0), as part of a stroke: the clock
// passes later, and cool() leaves that time out.
void let_heat_flow(World& world, double seconds);

// Lets heat flow while the clock passes by a time (s, >= 0), as far as strokes have not let it flow ahead.
void cool(World& world, double seconds);

// Cools bodies for ticks that have just passed by the clock of the world. Heat flows each kTicksOfFlow ticks
// of the clock at once, so that the result does not depend on how the ticks are divided.
inline constexpr Ticks kTicksOfFlow = 4;
void cool_for_ticks(World& world, Ticks passed);

// Lets heat flow in one body, and be lost from it, for a time (s, >= 0).
void let_heat_flow(World& world, BodyId id, double seconds);

// Whether any face is hotter than the environment. O(blocks of faces that were ever hot).
bool is_hot(const World& world);

}  // namespace kerf
