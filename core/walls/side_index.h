#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace kerf {

// The directed sides of triangles by the vertex at which they start. Linear in the triangles and vertices.
class SideIndex {
 public:
  struct Side {
    uint32_t to, triangle, corner;  // from this corner, 0 .. 2, of the triangle
  };

  // Precondition: corners are below `vertices`.
  SideIndex(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices);

  // The sides that start at a vertex, in the order of the triangles.
  std::span<const Side> from(uint32_t v) const {
    return std::span(sides_).subspan(first_[v], first_[v + 1] - first_[v]);
  }
  // The first side between two vertices in this direction, or null. Linear in the sides that start there.
  const Side* find(uint32_t v, uint32_t to) const;
  // A side that occurs more than once, or whose ends are equal; null if there is none.
  const Side* find_repeated() const;

 private:
  std::vector<uint32_t> first_;  // by vertex
  std::vector<Side> sides_;
};

}  // namespace kerf
