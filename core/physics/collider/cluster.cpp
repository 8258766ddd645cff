#include "core/physics/collider/cluster.h"

#include <algorithm>
#include <numeric>

#include "core/base/assert.h"
#include "core/physics/collider/box.h"

namespace kerf {

namespace {

constexpr uint32_t kMostInLeaf = 8;
constexpr uint32_t kSmaller = 4;  // times than the cluster around it, at least, unless it holds the items

}  // namespace

class ClusterDivision {
 public:
  ClusterDivision(std::span<const std::array<Vec3, 2>> segments, Clustering& out)
      : segments_(segments), out_(out) {}

  // `around`: how many items the cluster around these has.
  void divide(uint32_t begin, uint32_t end, uint32_t around) {
    const bool holds_items = end - begin <= kMostInLeaf;
    const bool is_node = holds_items || kSmaller * (end - begin) <= around;
    const size_t node = out_.clusters.nodes_.size();
    if (is_node) out_.clusters.nodes_.push_back({ball_around(begin, end), 0});
    if (!holds_items) halve(begin, end, is_node ? end - begin : around);
    if (is_node) out_.clusters.nodes_[node].next = static_cast<uint32_t>(out_.clusters.nodes_.size());
  }

 private:
  void halve(uint32_t begin, uint32_t end, uint32_t around) {
    const int axis = widest_axis(begin, end);
    const auto first = out_.order.begin();
    std::stable_sort(first + begin, first + end,
                     [&](uint32_t a, uint32_t b) { return middle(a)[axis] < middle(b)[axis]; });
    const uint32_t half = begin + (end - begin) / 2;
    divide(begin, half, around);
    divide(half, end, around);
  }

  Vec3 middle(uint32_t i) const { return 0.5 * (segments_[i][0] + segments_[i][1]); }

  int widest_axis(uint32_t begin, uint32_t end) const {
    Box box;
    for (uint32_t i = begin; i < end; ++i) box.add(middle(out_.order[i]));
    return box.widest_axis();
  }

  Cluster ball_around(uint32_t begin, uint32_t end) const {
    KERF_ASSERT(begin < end && end <= out_.order.size());
    Box box;
    for (uint32_t i = begin; i < end; ++i) {
      for (const Vec3& p : segments_[out_.order[i]]) box.add(p);
    }
    Cluster cluster{begin, end, 0.5 * (box.min + box.max), 0};
    for (uint32_t i = begin; i < end; ++i) {
      for (const Vec3& p : segments_[out_.order[i]])
        cluster.radius = std::max(cluster.radius, glm::length(p - cluster.centre));
    }
    return cluster;
  }

  std::span<const std::array<Vec3, 2>> segments_;
  Clustering& out_;
};

Clustering make_clusters(std::span<const std::array<Vec3, 2>> segments) {
  Clustering out;
  if (segments.empty()) return out;
  out.order.resize(segments.size());
  std::iota(out.order.begin(), out.order.end(), 0u);
  const auto count = static_cast<uint32_t>(segments.size());
  ClusterDivision(segments, out).divide(0, count, kSmaller * count);
  return out;
}

}  // namespace kerf
