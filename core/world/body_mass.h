#pragma once

#include <cstdint>
#include <optional>

#include "core/world/world.h"

namespace kerf {

// Finds the pieces of a solid body that are closed and enclose a volume, and stores their mass properties in
// Body::enclosed: a function of the faces of each piece, independent of their order and slots. Edits only
// changed entries. Precondition: the areas of the pieces are those of update_mass_properties(). O(faces +
// pieces).
void update_solid_mass(Body& body);

// Returns the volume of a piece, or null if its mass is that of a sheet: the body is not solid, the piece was
// open when it was last computed, or its faces have changed since.
const EnclosedPiece* enclosed_piece(const Body& body, uint32_t label);

// Recomputes the area and the moments of every piece of a body from its faces; the running sums kept by edits
// depend on the order of these edits in their last digits. The new sums are computed in fixed point and
// rounded once, so that they are a function of the faces, independent of their order and slots, and equal for
// a piece detached afterwards. Edits only changed entries. A search for separated pieces may be open. For a
// solid body it also finds the closed pieces and their volumes (see Body::enclosed). O(faces + pieces).
void update_mass_properties(Body& body);

// Makes a body a solid or a sheet, and updates its mass properties. Body::material_names of a solid body
// contain Body::cut_material. O(faces).
void make_solid(Body& body, bool solid);

// Returns the index of Body::cut_material; nullopt if there is none: the body was never solid, or has more
// materials than faces can index.
std::optional<uint16_t> cut_material(const Body& body);

}  // namespace kerf
