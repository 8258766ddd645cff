#pragma once

#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// Whether no other piece of the same body has faces.
bool stands_alone(const World& world, const PieceId& piece);

// Makes a piece a body of its own and returns the id of that body: a new one of this generation, or the old
// one where the piece stands alone. The piece keeps its label, its placement and its name (see
// Body::name_of); the rest of the body keeps the old id. Appends the change to `delta`.
//
// The smaller of the two sides, by faces, is copied to new arrays; where that is the rest, the bodies of the
// two ids are then exchanged. So ids of faces and vertices hold on for the larger side alone.
//
// Precondition: the piece has faces. O(n log n) in the faces of the smaller side, and O(n) in those of the
// body.
BodyId detach(World& world, const PieceId& piece, uint32_t generation, Delta& delta);

// Adds a copy of a piece as a body of its own of this generation and returns its id. The copy has the label
// and the placement of the piece, and its name with "copy" after it. Appends the change to `delta`.
//
// Precondition: the piece has faces. O(n log n) in its faces, and O(n) in those of the body.
BodyId duplicate(World& world, const PieceId& piece, uint32_t generation, Delta& delta);

}  // namespace kerf
