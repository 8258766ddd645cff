#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/base/ids.h"
#include "core/base/union_find.h"

namespace kerf {

// Faces that hung together: the sets that ties, a removed face and what hung on it, make of them.
class TieClusters {
 public:
  // O(n log n).
  explicit TieClusters(std::span<const std::pair<FaceId, FaceId>> ties);

  // Every face of a tie once, ascending.
  std::span<const FaceId> faces() const { return faces_; }
  // A number of the cluster of the face at that place, below the number of faces.
  uint32_t cluster(uint32_t place) { return together_.find(place); }

 private:
  uint32_t place(FaceId f) const;

  std::vector<FaceId> faces_;
  UnionFind together_;
};

}  // namespace kerf
