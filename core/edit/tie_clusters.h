#pragma once

#include <cassert>
#include <span>
#include <utility>
#include <vector>

#include "core/base/ids.h"
#include "core/base/paged_array.h"
#include "core/base/union_find.h"

namespace kerf {

// The connected components of a graph of faces whose edges are ties. A tie is a pair of a removed face and
// one of its former neighbours.
class TieClusters {
 public:
  // Linear time. All items of `scratch` must be 0, and are 0 afterwards.
  TieClusters(std::span<const std::pair<FaceId, FaceId>> ties, PagedArray<uint32_t>& scratch);

  // The faces of all ties, each once, in the order in which they first appear.
  std::span<const FaceId> faces() const { return faces_; }
  // The cluster of faces()[place], named by the place of its first face. Precondition: place <
  // faces().size().
  uint32_t cluster(uint32_t place) {
    assert(place < faces_.size());
    return together_.find(place);
  }

 private:
  std::vector<FaceId> faces_;
  UnionFind together_;
};

}  // namespace kerf
