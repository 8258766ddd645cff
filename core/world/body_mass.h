#pragma once

#include <cstdint>
#include <optional>

#include "core/world/world.h"

namespace kerf {

// Finds the pieces of a solid body that are closed and enclose a volume, and notes their mass properties in
// Body::enclosed: a function of the faces of each piece alone, whatever their order and slots. Changes only
// what differs. Precondition: the areas of the pieces are those of update_mass_properties(). O(faces +
// pieces).
void weigh_solid(Body& body);

// What is known of the volume of a piece; null where it weighs as a sheet: where the body is not solid, the
// piece was open when it was weighed, or its faces have changed since.
const EnclosedPiece* enclosed_piece(const Body& body, uint32_t label);

// Computes the area and the moments of every piece of a body anew from its faces, in place of the sums that
// its edits have kept up, whose last digits depend on the order of these edits. The new sums are taken in
// fixed point and rounded once, so that they are a function of the faces alone, whatever their order and
// slots. A piece that is detached afterwards has the same sums as if it were weighed itself. Changes only
// what differs. A search for separated pieces may be open. Of a solid body it also finds the pieces that are
// closed, and their volumes (see Body::enclosed). O(faces + pieces).
void update_mass_properties(Body& body);

// The name of the material that walls of a kerf have. A solid body has it in Body::material_names.
inline constexpr const char* kCutMaterial = "cut";

// Makes the faces of a body those of a solid, or of a sheet, and weighs it. O(faces).
void make_solid(Body& body, bool solid);

// The index of kCutMaterial; nothing where the body has none, as one that was never solid or that has more
// materials than faces can tell apart.
std::optional<uint16_t> cut_material(const Body& body);

}  // namespace kerf
