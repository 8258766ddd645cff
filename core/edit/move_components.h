#pragma once

#include <map>

#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Makes faces of loaded components that are at home in one piece belong to another: `label_of` has the labels
// by component, which may be those of new pieces. Preconditions: the body is settled, and no component goes to
// a piece that was cut off it, which could not be told from it any more. O(faces).
BodyDelta move_components(BodyId id, Body& body, const std::map<uint32_t, uint32_t>& label_of);

}  // namespace kerf
