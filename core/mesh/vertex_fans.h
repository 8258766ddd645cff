#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace kerf {

// The vertices of a mesh: one for each fan of triangles around a position. They have the order of their
// positions and, at one position, of the lowest sides that start there.
struct VertexFans {
  std::vector<uint32_t> position;   // by vertex
  std::vector<uint32_t> last_side;  // by vertex: the highest side that starts there

  uint32_t count() const { return static_cast<uint32_t>(position.size()); }
};

// Finds the fans, i.e. the sets of sides with one tail that are connected over paired sides, and replaces the
// corners of the triangles, which are numbers of positions, by vertices. Side 3 t + i runs from corner i of
// triangle t to its next corner; partner[side] is the side of another triangle on the same edge in the
// opposite direction, or kNoSide. Fails with cancelled() when stopped; the triangles are then in no usable
// state. `progress` may be null. Precondition: all corners are below `positions`. Linear time, on several
// threads.
inline constexpr uint32_t kNoSide = 0xffffffffu;
Result<VertexFans> name_vertices(std::vector<std::array<uint32_t, 3>>& triangles, size_t positions,
                                 std::span<const uint32_t> partner, const Progress* progress);

}  // namespace kerf
