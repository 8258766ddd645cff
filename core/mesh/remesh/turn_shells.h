#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/remesh/remeshed.h"

namespace kerf {

// Turns the closed parts of a mesh that lie in others and overlap with them, so that their volumes add up: a
// part inside another one becomes a cavity, and one inside a cavity a solid (see overlapping_patches). Faces
// that are not turned stay the same to the bit and in the same order. Fails with cancelled() when stopped;
// `progress` may be null. O(n log n).
Result<Remeshed> turn_shells(const Mesh& mesh, const Progress* progress);

}  // namespace kerf
