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

// The clusters of a list of items in a hierarchy, so that what lies far away is left out with few tests.
class Clusters {
 public:
  // Whether `test` holds for the index of any item of the clusters for which, and for those around which,
  // `near` holds. In the order of the list; ends with the first.
  template <typename Near, typename Test>
  bool any_of(const Near& near, const Test& test) const {
    for (uint32_t n = 0; n < nodes_.size();) {
      const Node& node = nodes_[n];
      if (!near(node.cluster)) {
        n = node.next;
        continue;
      }
      if (node.next == ++n) {
        for (uint32_t i = node.cluster.begin; i < node.cluster.end; ++i) {
          if (test(i)) return true;
        }
      }
    }
    return false;
  }
  template <typename Near, typename Work>
  void for_each(const Near& near, const Work& work) const {
    any_of(near, [&](uint32_t i) {
      work(i);
      return false;
    });
  }

 private:
  friend class ClusterDivision;
  struct Node {
    Cluster cluster;
    uint32_t next = 0;  // the node after all that lie in this one: the following one for a cluster of items
  };
  std::vector<Node> nodes_;  // each followed by those that lie in it
};

struct Clustering {
  std::vector<uint32_t> order;  // the items, such that those of a cluster follow each other
  Clusters clusters;
};

// Divides segments (points are segments of length 0) into clusters of at most eight: lists that are longer
// are halved along the largest extent of their middles. Deterministic. O(n log^2 n).
Clustering make_clusters(std::span<const std::array<Vec3, 2>> segments);

}  // namespace kerf
