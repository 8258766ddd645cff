#include "core/mesh/soup_edges.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/parallel.h"

namespace kerf {

namespace {

constexpr size_t kVertices = 1 << 14;  // a range

// Groups sides by a counting sort by the lesser vertex, then each bucket by the greater one.
class SideGrouping {
 public:
  SideGrouping(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices)
      : triangles_(triangles), begin_(vertices + 1, 0) {}

  Result<SoupEdges> run(const Progress* progress) {
    ProgressShares shares(progress);
    const Progress placing = shares.next(0.4), sorting = shares.next(0.4), naming = shares.next(0.2);
    for_each_part([&](uint32_t low) { count(low); });
    if (!placing.report(0.4)) return cancelled();
    for (size_t v = 0; v < vertices(); ++v) begin_[v + 1] += begin_[v];
    edges_.sides.resize(side_count());
    is_first_.resize(side_count());
    next_.assign(begin_.begin(), begin_.end() - 1);
    for_each_part([&](uint32_t low) { place(low); });
    if (!placing.report(1)) return cancelled();
    const auto sort = [&](size_t v, size_t end) { edges_before_[v / kVertices + 1] = sort_buckets(v, end); };
    edges_before_.assign(range_count(vertices(), kVertices) + 1, 0);
    if (!for_each_range(vertices(), kVertices, &sorting, sort)) return cancelled();
    for (size_t r = 1; r < edges_before_.size(); ++r) edges_before_[r] += edges_before_[r - 1];
    edges_.first.resize(edges_before_.back() + 1);
    edges_.first.back() = side_count();
    const auto name = [&](size_t v, size_t end) { name_edges(v, end, edges_before_[v / kVertices]); };
    if (!for_each_range(vertices(), kVertices, &naming, name)) return cancelled();
    return std::move(edges_);
  }

 private:
  size_t vertices() const { return begin_.size() - 1; }
  uint32_t side_count() const { return static_cast<uint32_t>(3 * triangles_.size()); }

  // Calls work(low) for every part of the vertices, low being its first vertex. Each call passes over all
  // triangles for the sides whose lesser vertex is in its part, so that no two calls write to one place.
  template <typename Work>
  void for_each_part(Work work) {
    constexpr size_t kMost = 4;  // parts, because each passes over everything
    part_ =
        static_cast<uint32_t>(std::max<size_t>(1, range_count(vertices(), std::min(kMost, thread_count()))));
    for_each_range(vertices(), part_, [&](size_t low, size_t) { work(static_cast<uint32_t>(low)); });
  }

  template <typename Visit>
  void for_each_side(uint32_t low, Visit visit) const {
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
      const auto& corners = triangles_[t];
      for (uint32_t i = 0; i < 3; ++i) {
        const uint32_t a = corners[i], b = corners[i == 2 ? 0 : i + 1], lesser = std::min(a, b);
        assert(a != b && std::max(a, b) < vertices());
        if (lesser - low < part_) visit(lesser, 3 * t + i);
      }
    }
  }
  void count(uint32_t low) {
    for_each_side(low, [&](uint32_t lesser, uint32_t) { ++begin_[lesser + 1]; });
  }
  void place(uint32_t low) {
    for_each_side(low, [&](uint32_t lesser, uint32_t side) { edges_.sides[next_[lesser]++] = side; });
  }

  uint32_t greater(uint32_t side) const {
    const auto& corners = triangles_[side / 3];
    const uint32_t i = side % 3;
    return std::max(corners[i], corners[i == 2 ? 0 : i + 1]);
  }

  // Sorts the buckets of these vertices by the greater vertex and then by side, and marks where a new edge
  // begins. Returns the number of edges.
  uint32_t sort_buckets(size_t first, size_t last) {
    struct Side {
      uint32_t greater, side;
      bool operator<(const Side& o) const {
        return greater != o.greater ? greater < o.greater : side < o.side;
      }
    };
    std::vector<Side> bucket;
    uint32_t edges = 0;
    for (size_t v = first; v < last; ++v) {
      bucket.clear();
      for (uint32_t i = begin_[v]; i < begin_[v + 1]; ++i)
        bucket.push_back({greater(edges_.sides[i]), edges_.sides[i]});
      std::sort(bucket.begin(), bucket.end());
      for (size_t i = 0; i < bucket.size(); ++i) {
        const bool is_first = i == 0 || bucket[i].greater != bucket[i - 1].greater;
        edges_.sides[begin_[v] + i] = bucket[i].side;
        is_first_[begin_[v] + i] = is_first;
        edges += is_first;
      }
    }
    return edges;
  }

  void name_edges(size_t first, size_t last, uint32_t edge) {
    for (uint32_t i = begin_[first]; i < begin_[last]; ++i) {
      if (is_first_[i]) edges_.first[edge++] = i;
    }
  }

  std::span<const std::array<uint32_t, 3>> triangles_;
  uint32_t part_ = 0;              // vertices a part
  std::vector<uint32_t> begin_;    // by lesser vertex: the first of its sides; while counting one further on
  std::vector<uint32_t> next_;     // by lesser vertex: the place of its next side
  std::vector<uint8_t> is_first_;  // by place: whether an edge begins there
  std::vector<uint32_t> edges_before_;  // by range of vertices
  SoupEdges edges_;
};

}  // namespace

Result<SoupEdges> group_sides(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices,
                              const Progress* progress) {
  return SideGrouping(triangles, vertices).run(progress);
}

SoupEdges group_sides(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices) {
  return std::move(*group_sides(triangles, vertices, nullptr));
}

std::vector<uint32_t> edges_of_sides(const SoupEdges& edges) {
  std::vector<uint32_t> edge_of(edges.sides.size());
  for (uint32_t e = 0; e < edges.count(); ++e) {
    for (const uint32_t side : edges.sides_of(e)) edge_of[side] = e;
  }
  return edge_of;
}

}  // namespace kerf
