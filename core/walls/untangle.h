#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "core/walls/chart_region.h"

namespace kerf {

// The edges of a rim in its chart.
struct RimInChart {
  std::span<const ChartVertex> placed;  // vertices
  std::span<const Vec3> at;             // the same, m
  std::vector<ChartEdge> edges;
  int64_t width = 0;  // of the chart
};

// The windings of the edges around the points of the chart. A rim may be off the boundary by a little, and
// its edges are chords: where some cross or touch, triangles no higher than `highest` (m) are cut off at
// vertices there, the smallest first, which become faces of the wall and are appended to `cut_off`. No third
// side of such a triangle runs between vertices for which `are_joined` holds. Returns nothing where that does
// not help; `conflict` then holds vertices of edges that cross or touch. O(n log n) for each triangle that is
// cut off.
Resumable<std::optional<ChartRegion::Winding>> untangle(
    RimInChart& rim, double highest, const std::function<bool(uint32_t, uint32_t)>& are_joined,
    std::vector<std::array<uint32_t, 3>>& cut_off, std::vector<uint32_t>& conflict);

}  // namespace kerf
