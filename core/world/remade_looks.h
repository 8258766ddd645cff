#pragma once

#include <memory>

#include "core/world/body_creation.h"

namespace kerf {

// Returns the looks of the body that replaces a piece; null if `body` has none. The values at a corner are
// those at the nearest point of the original surface, on the same side of a seam, except for UVs that the
// tool has carried (see Remeshed::uv_sets). Preconditions: `remeshed`
// was computed from `copy.mesh`, and `copy` is of `body`. O(n log n).
std::shared_ptr<const Looks> remade_looks(const Body& body, const PieceCopy& copy, const Remeshed& remeshed);

}  // namespace kerf
