#pragma once

#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// Returns true if no other piece of the same body has faces.
bool is_only_piece(const World& world, const PieceId& piece);

// Makes a piece a separate body and returns its id: a new body of this generation, or the old one if the
// piece is its only one. The piece keeps its label, placement and name (see Body::name_of); the rest of the
// body keeps the old id. Appends the change to `delta`.
//
// The side with fewer faces is copied to new arrays; if that is the rest, the bodies of the two ids are then
// exchanged. So only the larger side keeps its ids of faces and vertices.
//
// Precondition: the piece has faces. O(n log n) in the faces of the smaller side, and O(n) in those of the
// body.
BodyId detach(World& world, const PieceId& piece, uint32_t generation, Delta& delta);

// Adds a copy of a piece as a separate body of this generation and returns its id. The copy has the label and
// the placement of the piece, and its name with " copy" appended. Appends the change to `delta`.
//
// Precondition: the piece has faces. O(n log n) in its faces, and O(n) in those of the body.
BodyId duplicate(World& world, const PieceId& piece, uint32_t generation, Delta& delta);

}  // namespace kerf
