#include "core/mesh/remesh/flat_surface.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"

namespace kerf {

FlatSurface::FlatSurface(std::vector<Vec3> points, std::vector<std::array<uint32_t, 3>> corners)
    : points_(std::move(points)),
      corners_(std::move(corners)),
      next_(3 * corners_.size()),
      previous_(next_.size()),
      first_(points_.size(), kNoIndex),
      valence_(points_.size(), 0) {
  for (uint32_t c = 0; c < next_.size(); ++c) {
    const uint32_t v = corners_[c / 3][c % 3];
    ++valence_[v];
    if (first_[v] == kNoIndex) {
      first_[v] = next_[c] = previous_[c] = c;
    } else {
      const uint32_t after = next_[first_[v]];
      link(first_[v], c);
      link(c, after);
    }
  }
}

void FlatSurface::link(uint32_t corner, uint32_t after) {
  next_[corner] = after;
  previous_[after] = corner;
}

void FlatSurface::unlink(uint32_t corner) {
  const uint32_t before = previous_[corner], v = corners_[corner / 3][corner % 3];
  link(before, next_[corner]);
  first_[v] = before == corner ? kNoIndex : before;
  --valence_[v];
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
    const uint32_t after = next_[first], after_to = next_[first_[to]];
    link(first, after_to);
    link(first_[to], after);
  }
  valence_[to] += std::exchange(valence_[from], 0);
}

}  // namespace kerf
