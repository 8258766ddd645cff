#pragma once

#include <span>

#include "core/mesh/mesh.h"

namespace kerf {

// Copies some faces of a mesh into a mesh of their own. Positions, orientation, the order of faces around
// vertices, rings, face data, columns and colours are preserved to the bit, except for references to other
// faces: green pairs are dropped, and the base of a face becomes the face itself if it was never split, else
// the first of the extracted faces that share the base. Slots have the order of `faces`. Parts that touch in
// a vertex get a vertex each.
//
// Preconditions: `faces` are live, ascending and not empty, and contain with each face all faces connected to
// it over edges. O(n log n).
Mesh extract_mesh(const Mesh& mesh, std::span<const FaceId> faces);

}  // namespace kerf
