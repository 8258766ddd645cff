#include "core/physics/contact/bounding_volumes.h"

#include <algorithm>
#include <numeric>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr uint32_t kMaxInLeaf = 8;
constexpr uint32_t kSmaller =
    4;  // min ratio to the size of the enclosing cluster, unless the cluster holds items

}  // namespace

class ClusterDivision {
 public:
  ClusterDivision(std::span<const std::array<Vec3, 2>> segments, Clustering& out)
      : segments_(segments), out_(out) {}

  // `around`: the number of items of the enclosing cluster.
  void divide(uint32_t begin, uint32_t end, uint32_t around) {
    const bool holds_items = end - begin <= kMaxInLeaf;
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

Occupancy::Occupancy(const Box& bounds) : bounds_(bounds) {
  KERF_ASSERT(bounds.min.x <= bounds.max.x && bounds.min.y <= bounds.max.y && bounds.min.z <= bounds.max.z);
  const Vec3 extent = bounds.max - bounds.min;
  const double longest = std::max({extent.x, extent.y, extent.z});
  per_metre_ = longest > 0 ? kMaxCells / longest : 0;
  for (int k = 0; k < 3; ++k) {
    count_[k] = std::min(static_cast<int>(extent[k] * per_metre_) + 1, kMaxCells);
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
