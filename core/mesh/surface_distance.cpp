#include "core/mesh/surface_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/assert.h"
#include "core/mesh/point_to_triangle.h"

namespace kerf {

namespace {

constexpr uint32_t kMostInLeaf = 4;  // triangles

// Boxes over triangles, each divided in the middle of its triangles along its longest side. The children of
// node n are n + 1 and Node::second.
class TriangleBoxes {
 public:
  explicit TriangleBoxes(std::span<const Triangle> triangles)
      : triangles_(triangles.begin(), triangles.end()) {
    nodes_.reserve(triangles.size());
    build(0, static_cast<uint32_t>(triangles_.size()));
  }

  // The squared distance of a point, or any value up to `enough` if it is not larger than that.
  double squared_distance_above(const Vec3& p, double enough) {
    double nearest = std::numeric_limits<double>::infinity();
    waiting_.assign(1, {nodes_[0].squared_distance(p), 0});
    while (!waiting_.empty() && nearest > enough) {
      const auto [bound, at] = waiting_.back();
      waiting_.pop_back();
      if (bound >= nearest) continue;
      const Node& node = nodes_[at];
      for (uint32_t i = node.begin; i < node.end; ++i)
        nearest = std::min(nearest, squared_distance(p, triangles_[i]));
      if (node.second == 0) continue;
      std::array<Visit, 2> children{Visit{nodes_[at + 1].squared_distance(p), at + 1},
                                    Visit{nodes_[node.second].squared_distance(p), node.second}};
      if (children[0].bound < children[1].bound) std::swap(children[0], children[1]);
      waiting_.insert(waiting_.end(), children.begin(), children.end());
    }
    return nearest;
  }

 private:
  struct Node {
    Vec3 low, high;
    uint32_t begin = 0, end = 0;  // the triangles of a leaf
    uint32_t second = 0;          // 0: a leaf

    double squared_distance(const Vec3& p) const {
      const Vec3 way = glm::max(glm::max(low - p, p - high), Vec3(0));
      return glm::dot(way, way);
    }
  };
  struct Visit {
    double bound;  // no triangle of the node is nearer
    uint32_t node;
  };

  uint32_t build(uint32_t begin, uint32_t end) {
    const auto made = static_cast<uint32_t>(nodes_.size());
    Node node{Vec3(std::numeric_limits<double>::infinity()), Vec3(-std::numeric_limits<double>::infinity())};
    for (uint32_t i = begin; i < end; ++i) {
      for (const Vec3& corner : triangles_[i]) {
        node.low = glm::min(node.low, corner);
        node.high = glm::max(node.high, corner);
      }
    }
    nodes_.push_back(node);
    if (end - begin <= kMostInLeaf) {
      nodes_[made].begin = begin;
      nodes_[made].end = end;
      return made;
    }
    const Vec3 size = node.high - node.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const uint32_t middle = begin + (end - begin) / 2;
    const auto place = [axis](const Triangle& t) { return t[0][axis] + t[1][axis] + t[2][axis]; };
    std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle, triangles_.begin() + end,
                     [&](const Triangle& a, const Triangle& b) { return place(a) < place(b); });
    build(begin, middle);
    const uint32_t second = build(middle, end);
    nodes_[made].second = second;
    return made;
  }

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  std::vector<Visit> waiting_;
};

std::array<Vec3, 7> samples_of(const Triangle& t) {
  return {t[0],
          t[1],
          t[2],
          0.5 * (t[0] + t[1]),
          0.5 * (t[1] + t[2]),
          0.5 * (t[2] + t[0]),
          (t[0] + t[1] + t[2]) / 3.0};
}

// Raises `most`, a squared distance, to that of the sample of `from` that is farthest from `to`. Returns
// false if it was stopped.
bool raise(std::span<const Triangle> from, TriangleBoxes& to, const Progress& progress, double& most) {
  const size_t sampled = std::min(from.size(), kMostSampled);
  Pace pace(&progress, sampled);
  for (size_t i = 0; i < sampled; ++i) {
    for (const Vec3& p : samples_of(from[i * from.size() / sampled]))
      most = std::max(most, to.squared_distance_above(p, most));
    if (!pace.step()) return false;
  }
  return true;
}

}  // namespace

Result<double> surface_distance(std::span<const Triangle> one, std::span<const Triangle> other,
                                const Progress* progress) {
  KERF_ASSERT(!one.empty() && !other.empty());
  ProgressShares shares(progress);
  double most = 0;
  for (const bool back : {false, true}) {
    const Progress half = shares.next(0.5);
    TriangleBoxes boxes(back ? one : other);
    if (!raise(back ? other : one, boxes, half, most)) return cancelled();
  }
  return std::sqrt(most);
}

}  // namespace kerf
