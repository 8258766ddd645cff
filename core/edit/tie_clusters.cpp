#include "core/edit/tie_clusters.h"

namespace kerf {

namespace {

// The faces of all ties, each once. Leaves the place of each in the list plus one in `place`.
std::vector<FaceId> faces_of(std::span<const std::pair<FaceId, FaceId>> ties, PagedArray<uint32_t>& place) {
  std::vector<FaceId> faces;
  const auto add = [&](FaceId f) {
    uint32_t& own = place.at(f.index);
    if (own != 0) return;
    faces.push_back(f);
    own = static_cast<uint32_t>(faces.size());
  };
  for (const auto& [removed, beside] : ties) {
    add(removed);
    add(beside);
  }
  return faces;
}

}  // namespace

TieClusters::TieClusters(std::span<const std::pair<FaceId, FaceId>> ties, PagedArray<uint32_t>& scratch)
    : faces_(faces_of(ties, scratch)), together_(faces_.size()) {
  for (const auto& [removed, beside] : ties)
    together_.unite(scratch.get(removed.index) - 1, scratch.get(beside.index) - 1);
  for (const FaceId f : faces_) scratch.at(f.index) = 0;
}

}  // namespace kerf
