#pragma once

#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Whether parts were separated from a solid body since hold_cavities() looked at it, or one is being searched
// for.
bool cavities_asked(const Body& body);

// Gives closed parts that bound a cavity, i.e. whose faces enclose a negative volume, to the piece of a solid
// body whose material is around them: the walls of a cut do not join them to it where the beam did not touch
// them. Precondition: the body is settled. O(faces + cavities * crossings of a ray) where it was asked for,
// else O(1).
void hold_cavities(BodyId id, Body& body, Delta& delta);

}  // namespace kerf
