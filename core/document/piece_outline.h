#pragma once

#include <optional>
#include <vector>

#include "core/document/extract.h"
#include "core/laser/drawing.h"

namespace kerf {

// Returns the outline of a flat piece as closed lines, the outer ones counter-clockwise and holes clockwise:
// the boundary of a flat sheet, or of the upper side of a plate, i.e. of a closed piece with two parallel
// sides of equal area whose distance times this area is its volume, to 1 %. Returns nullopt for any other
// piece.
//
// The coordinates are those of plane_onto() for the beam along the negative coordinate axis that is nearest
// to the normal, with its zero at that of the world; right and up are turned into the plane if it is oblique.
// O(n log n).
std::optional<std::vector<DrawnLine>> flat_outline(const Extract& piece);

}  // namespace kerf
