#pragma once

#include <span>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"

namespace kerf {

// How far two surfaces are from each other at most, measured both ways (the Hausdorff distance, m), from
// samples: corners, midpoints of sides and the middle of at most kMostSampled triangles of each, spread
// evenly. Samples that cannot raise the result are left early (A. A. Taha, A. Hanbury: An efficient algorithm
// for calculating the exact Hausdorff distance, 2015). Fails with cancelled() when stopped; `progress` may be
// null. Precondition: neither surface is empty. O(n log n).
inline constexpr size_t kMostSampled = 200'000;
Result<double> surface_distance(std::span<const Triangle> one, std::span<const Triangle> other,
                                const Progress* progress);

}  // namespace kerf
