#include "core/mesh/remesh/flat_surface.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"

namespace kerf {

FlatSurface::FlatSurface(std::vector<Vec3> points, std::vector<std::array<uint32_t, 3>> corners)
    : points_(std::move(points)),
      corners_(std::move(corners)),
      next_(3 * corners_.size()),
      first_(points_.size(), kNoIndex) {
  for (uint32_t c = 0; c < next_.size(); ++c) {
    uint32_t& first = first_[corners_[c / 3][c % 3]];
    if (first == kNoIndex) {
      first = next_[c] = c;
    } else {
      next_[c] = std::exchange(next_[first], c);
    }
  }
}

void FlatSurface::unlink(uint32_t corner) {
  uint32_t before = corner;
  while (next_[before] != corner) before = next_[before];
  uint32_t& first = first_[corners_[corner / 3][corner % 3]];
  next_[before] = next_[corner];
  first = before == corner ? kNoIndex : before;
}

void FlatSurface::collapse(uint32_t from, uint32_t to) {
  std::array<uint32_t, 2> gone{};
  size_t count = 0;
  for_each_face(from, [&](const Opposite& side) {
    if (side.from != to && side.to != to) return;
    KERF_ASSERT(count < gone.size());
    gone[count++] = side.face;
  });
  KERF_ASSERT(count == gone.size());
  for (const uint32_t f : gone) {
    for (uint32_t i = 0; i < 3; ++i) unlink(3 * f + i);
    corners_[f].fill(kNoIndex);
  }
  const uint32_t first = std::exchange(first_[from], kNoIndex);
  KERF_ASSERT(first != kNoIndex);
  uint32_t c = first;
  do {
    corners_[c / 3][c % 3] = to;
    c = next_[c];
  } while (c != first);
  if (first_[to] == kNoIndex) {
    first_[to] = first;
  } else {
    std::swap(next_[first], next_[first_[to]]);
  }
}

}  // namespace kerf
