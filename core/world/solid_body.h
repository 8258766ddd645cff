#pragma once

#include <cstdint>
#include <optional>

#include "core/world/world.h"

namespace kerf {

// The name of the material that walls of a kerf have. A solid body has it in Body::material_names.
inline constexpr const char* kCutMaterial = "cut";

// Makes the faces of a body those of a solid, or of a sheet, and weighs it. O(faces).
void make_solid(Body& body, bool solid);

// The index of kCutMaterial; nothing where the body has none, as one that was never solid or that has more
// materials than faces can tell apart.
std::optional<uint16_t> cut_material(const Body& body);

}  // namespace kerf
