#pragma once

#include <cstdint>
#include <optional>

#include "core/world/world.h"

namespace kerf {

// Finds the pieces of a solid body that are closed and enclose a volume, and stores their mass properties in
// Body::enclosed: a function of the faces of each piece, independent of their order and slots. Writes only
// entries that changed. Precondition: update_mass_properties() computed the areas of the pieces. O(faces +
// pieces).
void update_solid_mass(Body& body);

// Returns the enclosed volume of a piece; null if the piece has the mass of a sheet, because the body is not
// solid, the piece was open at the last update, or its faces have changed since.
const EnclosedPiece* enclosed_piece(const Body& body, uint32_t label);

// Recomputes the area and the moments of every piece of a body from its faces. The last digits of the running
// sums that edits maintain depend on the order of the edits; the new sums are computed in fixed point and
// rounded once, so they are a function of the faces, independent of their order and slots, and equal for a
// piece detached afterwards. Writes only entries that changed. May be called during a search for separated
// pieces. For a solid body, also finds the closed pieces and their volumes (see Body::enclosed). O(faces +
// pieces).
void update_mass_properties(Body& body);

// Turns a body into a solid or a sheet, and updates its mass properties. Adds Body::cut_material to the
// Body::material_names of a solid body if it is missing. O(faces).
void make_solid(Body& body, bool solid);

// Returns the index of Body::cut_material; nullopt if the body was never solid, or has more materials than
// faces can index.
std::optional<uint16_t> cut_material(const Body& body);

}  // namespace kerf
