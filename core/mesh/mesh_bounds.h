#pragma once

#include "core/base/bounds.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"

namespace kerf {

// Returns the bounds of the live faces of a mesh, Bounds::none() if it has none, or cancelled() when stopped.
// `progress` may be null. Linear in the number of vertices, on several threads.
Result<Bounds> bounds_of(const Mesh& mesh, const Progress* progress);

}  // namespace kerf
