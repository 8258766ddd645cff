#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>

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

// Returns the group of faces around a cavity: the nearest one that a ray from `face`, into the material
// behind it, leaves once more than it enters; nullopt if there is none. `group_of` returns nullopt for the
// faces of all cavities. Precondition: `face` bounds a cavity.
std::optional<uint32_t> group_around(const Body& body, FaceId face,
                                     const std::function<std::optional<uint32_t>(FaceId)>& group_of);

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
// the placement of the piece, and its name with " copy" appended. It has no joints: those of the piece keep
// holding the piece alone. Appends the change to `delta`.
//
// Precondition: the piece has faces. O(n log n) in its faces, and O(n) in those of the body.
BodyId duplicate(World& world, const PieceId& piece, uint32_t generation, Delta& delta);

}  // namespace kerf
