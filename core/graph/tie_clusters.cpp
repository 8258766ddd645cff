#include "core/graph/tie_clusters.h"

#include <algorithm>

namespace kerf {

namespace {

std::vector<FaceId> faces_of(std::span<const std::pair<FaceId, FaceId>> ties) {
  std::vector<FaceId> faces;
  faces.reserve(2 * ties.size());
  for (const auto& [removed, beside] : ties) faces.insert(faces.end(), {removed, beside});
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace

TieClusters::TieClusters(std::span<const std::pair<FaceId, FaceId>> ties)
    : faces_(faces_of(ties)), together_(faces_.size()) {
  for (const auto& [removed, beside] : ties) together_.unite(place(removed), place(beside));
}

uint32_t TieClusters::place(FaceId f) const {
  return static_cast<uint32_t>(std::lower_bound(faces_.begin(), faces_.end(), f) - faces_.begin());
}

}  // namespace kerf
