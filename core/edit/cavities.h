#pragma once

#include <map>

#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// Moves the faces of loaded components at home in one piece to another: `label_of` has the labels by
// component, which may be those of new pieces. Preconditions: the body is settled, and no component moves to
// a piece that was cut off it, from which it would be indistinguishable. O(faces).
BodyDelta move_components(BodyId id, Body& body, const std::map<uint32_t, uint32_t>& label_of);

// Returns true if search_from() was called for new walls of a solid body since the last assign_cavities().
bool cavities_requested(const Body& body);

// Assigns closed parts that bound a cavity, i.e. whose faces enclose a negative volume, to the piece of a
// solid body that surrounds them: the walls of a cut do not connect cavities that the beam did not touch.
// Precondition: the body is settled. O(faces + cavities * crossings of a ray) if cavities_requested(), else
// O(1).
void assign_cavities(BodyId id, Body& body, Delta& delta);

}  // namespace kerf
