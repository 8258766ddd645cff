#pragma once

#include <string>

#include "core/world/world.h"

namespace kerf {

// Whether a piece is one that no cut separated: a part of its mesh that joints hold to others, or held, and
// that moves apart from them. Precondition: the body has that label.
bool is_loaded_part(const Body& body, uint32_t label);

// The name of such a piece in its mesh file, for the user: that of the smallest part that has all of its
// faces, or else of the part that has most of them. Empty if the file gives no names, or the body as which it
// was loaded is gone. O(faces of the body + parts).
std::string loaded_part_name(const World& world, const PieceId& piece);

}  // namespace kerf
