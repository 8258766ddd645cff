#pragma once

#include "core/base/tick.h"
#include "core/world/world.h"

namespace kerf {

// Conducts heat in all bodies, with losses to the environment, for a time (s, >= 0) of a stroke. The clock
// advances later, and cool() skips that time.
void step_heat(World& world, double seconds);

// Conducts heat while the clock advances by a time (s, >= 0), minus the time simulated ahead by strokes.
void cool(World& world, double seconds);

// Cools bodies for ticks that the clock of the world has just advanced. Heat flows once every kTicksOfFlow
// ticks, so that the result does not depend on how the ticks are divided.
inline constexpr Ticks kTicksOfFlow = 4;
void cool_for_ticks(World& world, Ticks passed);

// Conducts heat in one body, with losses to the environment, for a time (s, >= 0).
void step_heat(World& world, BodyId id, double seconds);

// Returns true if any face is hotter than the environment. O(blocks of faces that were ever hot).
bool is_hot(const World& world);

}  // namespace kerf
