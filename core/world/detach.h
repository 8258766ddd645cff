#pragma once

#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Whether a piece is all that its body has.
bool stands_alone(const Body& body, uint32_t label);

// Makes a piece a body of its own, where it is not one already, and returns that body. The piece keeps its
// label, its name is the body's and the label, and it stands where it stood. The smaller side, by faces, is
// copied out by arrays into the new body: the piece, or else all the rest, which then goes by the new id
// while the piece stays with the old one. Tells the delta.
//
// The piece has faces. O(n log n) of the smaller side, beside one look at every face of the body.
BodyId detach(World& world, BodyId id, uint32_t label, Delta& delta);

}  // namespace kerf
