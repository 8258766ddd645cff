#pragma once

#include <span>

#include "core/mesh/mesh.h"

namespace kerf {

// A mesh of some faces of another, to the bit as they were there: corners, orders of turns, rings and data, but
// for what refers to other faces: green pairs are forgotten, and the base of a face is itself where it was
// never split, else the first of those here that have it in common. Slots follow the order of the faces. Where
// parts touch in a vertex each has one of its own.
//
// faces: live, ascending, and with each all that hang together with it over edges. O(n log n).
Mesh extract_mesh(const Mesh& mesh, std::span<const FaceId> faces);

}  // namespace kerf
