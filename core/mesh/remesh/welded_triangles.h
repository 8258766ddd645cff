#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/weld.h"

namespace kerf {

// Collects triangles over welded positions: those with two corners at one position are left out, and
// positions are numbered in the order in which triangles use them.
class WeldedTriangles {
 public:
  // The positions must outlive the collection. Expected linear time.
  explicit WeldedTriangles(std::span<const Vec3> from)
      : from_(from), first_(weld_positions(from)), number_(from.size(), kNoIndex) {}

  // Adds a triangle of these positions. Returns whether it has three different corners.
  bool add(std::array<uint32_t, 3> corners) {
    for (uint32_t& v : corners) v = first_[v];
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return false;
    for (uint32_t& v : corners) {
      if (number_[v] == kNoIndex) {
        number_[v] = static_cast<uint32_t>(positions.size());
        positions.push_back(from_[v]);
        sources.push_back(v);
      }
      v = number_[v];
    }
    triangles.push_back(corners);
    return true;
  }

  std::vector<Vec3> positions;
  std::vector<uint32_t> sources;                   // by position: the lowest index of an equal one in `from`
  std::vector<std::array<uint32_t, 3>> triangles;  // indices of positions

 private:
  std::span<const Vec3> from_;
  std::vector<uint32_t> first_;   // by position: the lowest index of an equal one
  std::vector<uint32_t> number_;  // by that: its index in `positions`
};

}  // namespace kerf
