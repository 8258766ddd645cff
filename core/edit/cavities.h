#pragma once

#include <map>

#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// Makes faces of loaded components that are at home in one piece belong to another: `label_of` has the labels
// by component, which may be those of new pieces. Preconditions: the body is settled, and no component goes
// to a piece that was cut off it, which could not be told from it any more. O(faces).
BodyDelta move_components(BodyId id, Body& body, const std::map<uint32_t, uint32_t>& label_of);

// Whether parts were separated from a solid body since hold_cavities() looked at it, or one is being searched
// for.
bool cavities_asked(const Body& body);

// Gives closed parts that bound a cavity, i.e. whose faces enclose a negative volume, to the piece of a solid
// body whose material is around them: the walls of a cut do not join them to it where the beam did not touch
// them. Precondition: the body is settled. O(faces + cavities * crossings of a ray) where it was asked for,
// else O(1).
void hold_cavities(BodyId id, Body& body, Delta& delta);

}  // namespace kerf
