#pragma once

#include <memory>

#include "core/world/body_creation.h"

namespace kerf {

// Returns the looks of the body that replaces a piece; null if `body` has none. The values at a corner are
// those of the nearest point of the surface before, on the same side of a seam. Preconditions: `remeshed` was
// made of `copy.mesh`, which was made of `body`. O(n log n).
std::shared_ptr<const Looks> remade_looks(const Body& body, const PieceCopy& copy, const Remeshed& remeshed);

}  // namespace kerf
