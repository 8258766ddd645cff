#include "core/physics/collider/cluster.h"

#include <algorithm>
#include <numeric>

#include "core/base/assert.h"
#include "core/physics/collider/box.h"

namespace kerf {

namespace {

constexpr uint32_t kMost = 8;

class Divider {
 public:
  Divider(std::span<const std::array<Vec3, 2>> segments, Clustering& out) : segments_(segments), out_(out) {}

  void divide(uint32_t begin, uint32_t end) {
    if (end - begin <= kMost) {
      finish(begin, end);
      return;
    }
    const int axis = widest_axis(begin, end);
    const auto first = out_.order.begin();
    std::stable_sort(first + begin, first + end,
                     [&](uint32_t a, uint32_t b) { return middle(a)[axis] < middle(b)[axis]; });
    const uint32_t half = begin + (end - begin) / 2;
    divide(begin, half);
    divide(half, end);
  }

 private:
  Vec3 middle(uint32_t i) const { return 0.5 * (segments_[i][0] + segments_[i][1]); }

  int widest_axis(uint32_t begin, uint32_t end) const {
    Box box;
    for (uint32_t i = begin; i < end; ++i) box.add(middle(out_.order[i]));
    return box.widest_axis();
  }

  void finish(uint32_t begin, uint32_t end) {
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
    out_.clusters.push_back(cluster);
  }

  std::span<const std::array<Vec3, 2>> segments_;
  Clustering& out_;
};

}  // namespace

Clustering make_clusters(std::span<const std::array<Vec3, 2>> segments) {
  Clustering out;
  if (segments.empty()) return out;
  out.order.resize(segments.size());
  std::iota(out.order.begin(), out.order.end(), 0u);
  Divider(segments, out).divide(0, static_cast<uint32_t>(segments.size()));
  return out;
}

}  // namespace kerf
