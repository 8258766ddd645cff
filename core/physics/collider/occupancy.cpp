#include "core/physics/collider/occupancy.h"

namespace kerf {

Occupancy::Occupancy(const Box& bounds) : bounds_(bounds) {
  KERF_ASSERT(bounds.min.x <= bounds.max.x && bounds.min.y <= bounds.max.y && bounds.min.z <= bounds.max.z);
  const Vec3 extent = bounds.max - bounds.min;
  const double longest = std::max({extent.x, extent.y, extent.z});
  per_metre_ = longest > 0 ? kMostCells / longest : 0;
  for (int k = 0; k < 3; ++k) {
    count_[k] = std::min(static_cast<int>(extent[k] * per_metre_) + 1, kMostCells);
    last_[k] = count_[k] - 1;
  }
  rows_.resize(static_cast<size_t>(count_[1]) * static_cast<size_t>(count_[2]), 0);
}

void Occupancy::add(const Box& box) {
  Range range;
  if (!cells_of(box, range)) return;
  const uint64_t bits = row_bits(range);
  for (int z = range.first[2]; z <= range.last[2]; ++z) {
    for (int y = range.first[1]; y <= range.last[1]; ++y)
      rows_[static_cast<size_t>(y + z * count_[1])] |= bits;
  }
}

}  // namespace kerf
