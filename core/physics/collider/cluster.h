#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec3.h"

namespace kerf {

// Items that lie beside each other, in a list and in space, and a ball around them.
struct Cluster {
  uint32_t begin = 0, end = 0;  // the range of the items
  Vec3 centre{0};
  double radius = 0;
};

struct Clustering {
  std::vector<uint32_t> order;  // the items, such that those of a cluster follow each other
  std::vector<Cluster> clusters;
};

// Divides segments (points are segments of length 0) into clusters of at most eight: lists that are longer
// are halved along the largest extent of their middles. Deterministic. O(n log^2 n).
Clustering make_clusters(std::span<const std::array<Vec3, 2>> segments);

}  // namespace kerf
