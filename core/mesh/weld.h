#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Returns for each position the lowest index of an equal position. -0.0 equals +0.0, and a position with a
// NaN equals only itself. Expected linear time, by hashing.
std::vector<uint32_t> weld_positions(std::span<const Vec3> positions);
// Likewise, or fails with cancelled() when stopped. `progress` may be null.
Result<std::vector<uint32_t>> weld_positions(std::span<const Vec3> positions, const Progress* progress);

// The triangles of a soup that can form a mesh, in its order.
struct UsableTriangles {
  std::vector<Soup::Triangle> triangles;  // of welded positions
  std::vector<uint16_t> materials;        // one per triangle, or empty like the soup's
  std::vector<uint32_t> sources;          // by triangle: its index in the soup; empty if all are usable
  std::vector<MeshPart> parts;            // of these triangles; empty ones are dropped
  size_t degenerate = 0;                  // dropped: two corners at the same position
  size_t non_finite = 0;                  // dropped: a corner that is not finite
};

// Selects the usable triangles, or fails with cancelled() when stopped. `welded` is the result of
// weld_positions() for the soup. `progress` may be null. Linear time, multithreaded.
Result<UsableTriangles> usable_triangles(const Soup& soup, std::span<const uint32_t> welded,
                                         const Progress* progress);

// Collects triangles with welded positions. Drops triangles with two corners at one position, and numbers the
// positions in the order of their first use.
class WeldedTriangles {
 public:
  // The positions must outlive the collection. Expected linear time.
  explicit WeldedTriangles(std::span<const Vec3> from)
      : from_(from), first_(weld_positions(from)), number_(from.size(), kNoIndex) {}

  // Adds a triangle of these positions. Returns false if two of its corners coincide.
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
  std::vector<uint32_t> number_;  // by that index: the index in `positions`, or kNoIndex
};

}  // namespace kerf
