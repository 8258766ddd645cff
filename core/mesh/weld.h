#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/vec3.h"

namespace kerf {

// For each position the lowest index at which an equal position stands (-0.0 equals +0.0; a position that is
// not finite equals nothing but itself). Expected linear time, by hashing.
std::vector<uint32_t> weld_positions(std::span<const Vec3> positions);
// The same, or that it was stopped. `progress` may be null.
Result<std::vector<uint32_t>> weld_positions(std::span<const Vec3> positions, const Progress* progress);

}  // namespace kerf
