#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/vec3.h"

namespace kerf {

// For each position, the lowest index of an equal position. -0.0 equals +0.0, and a position with a NaN
// equals only itself. Expected linear time, by hashing.
std::vector<uint32_t> weld_positions(std::span<const Vec3> positions);
// Finds these indices, or fails with cancelled() when stopped. `progress` may be null.
Result<std::vector<uint32_t>> weld_positions(std::span<const Vec3> positions, const Progress* progress);

}  // namespace kerf
