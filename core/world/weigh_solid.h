#pragma once

#include "core/world/world.h"

namespace kerf {

// Finds the pieces of a solid body that are closed and enclose a volume, and notes their mass properties in
// Body::enclosed: a function of the faces of each piece alone, whatever their order and slots. Changes only
// what differs. Precondition: the areas of the pieces are those of weigh(). O(faces + pieces).
void weigh_solid(Body& body);

// What is known of the volume of a piece; null where it weighs as a sheet: where the body is not solid, the
// piece was open when it was weighed, or its faces have changed since.
const EnclosedPiece* enclosed_piece(const Body& body, uint32_t label);

}  // namespace kerf
