#include "core/mesh/soup_topology.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/containers.h"

namespace kerf {

namespace {

constexpr size_t kVertices = 1 << 14;  // per range

// Groups sides by a counting sort by the lower vertex, then sorts each bucket by the higher one.
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

  // Calls work(low) for every part of the vertices, where low is its first vertex. Each call scans all
  // triangles for the sides whose lower vertex is in its part, so that no two calls write to one place.
  template <typename Work>
  void for_each_part(Work work) {
    constexpr size_t kMost = 4;  // parts, because each scans all triangles
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

  // Sorts the buckets of these vertices by the higher vertex and then by side, and marks the beginnings of
  // edges. Returns the number of edges.
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
  uint32_t part_ = 0;              // vertices per part
  std::vector<uint32_t> begin_;    // by lower vertex: the first of its sides; while counting one further on
  std::vector<uint32_t> next_;     // by lower vertex: the place of its next side
  std::vector<uint8_t> is_first_;  // by place: whether an edge begins there
  std::vector<uint32_t> edges_before_;  // by range of vertices
  SoupEdges edges_;
};

class PatchFinder {
 public:
  PatchFinder(const std::vector<std::array<uint32_t, 3>>& triangles, const SoupEdges& edges,
              const Progress* progress)
      : triangles_(triangles), edges_(edges), progress_(progress), patch_of_(patches_.patch_of) {
    patch_of_.resize(triangles.size());
  }

  Result<Patches> run() {
    ProgressShares shares(progress_);
    const Progress numbering = shares.next(0.7), closing = shares.next(0.3);
    if (!number_patches(numbering)) return cancelled();
    group_triangles();
    if (!find_closed(closing)) return cancelled();
    return std::move(patches_);
  }

 private:
  // This and find_closed return false if stopped.
  bool number_patches(const Progress& progress) {
    Pace pace(&progress, edges_.count() + triangles_.size());
    UnionFind sets(triangles_.size());
    for (uint32_t e = 0; e < edges_.count(); ++e) {
      if (!pace.step()) return false;
      const auto sides = edges_.sides_of(e);
      if (sides.size() == 2) sets.unite(sides[0] / 3, sides[1] / 3);
    }
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
      if (!pace.step()) return false;
      const uint32_t lowest = sets.find(t);
      patch_of_[t] = lowest == t ? patch_count_++ : patch_of_[lowest];
    }
    return true;
  }

  void group_triangles() {
    patches_.first.assign(patch_count_ + 1, 0);
    for (const uint32_t p : patch_of_) ++patches_.first[p + 1];
    for (size_t p = 0; p < patch_count_; ++p) patches_.first[p + 1] += patches_.first[p];
    std::vector<uint32_t> next(patches_.first.begin(), patches_.first.end() - 1);
    patches_.triangles.resize(triangles_.size());
    for (uint32_t t = 0; t < triangles_.size(); ++t) patches_.triangles[next[patch_of_[t]]++] = t;
  }

  bool find_closed(const Progress& progress) {
    constexpr size_t kEdges = 1 << 16;  // per range
    std::vector<std::vector<uint32_t>> open(range_count(edges_.count(), kEdges));
    const auto look = [&](size_t e, size_t end) {
      std::vector<uint32_t>& found = open[e / kEdges];
      for (; e < end; ++e) append_unbalanced(edges_.sides_of(static_cast<uint32_t>(e)), found);
    };
    if (!for_each_range(edges_.count(), kEdges, &progress, look)) return false;
    patches_.closed.assign(patch_count_, true);
    for (const auto& found : open) {
      for (const uint32_t patch : found) patches_.closed[patch] = false;
    }
    return true;
  }

  // Appends those patches that traverse an edge more often one way than the other.
  void append_unbalanced(std::span<const uint32_t> sides, std::vector<uint32_t>& found) const {
    const auto note = [&](uint32_t patch) {
      if (found.empty() || found.back() != patch) found.push_back(patch);
    };
    if (sides.size() == 1) return note(patch_of_[sides[0] / 3]);
    if (sides.size() == 2) {
      if (goes_up(sides[0]) == goes_up(sides[1])) note(patch_of_[sides[0] / 3]);
      return;
    }
    std::vector<std::pair<uint32_t, int>> around;  // patch and direction of each side
    for (const uint32_t s : sides) around.push_back({patch_of_[s / 3], goes_up(s) ? 1 : -1});
    std::sort(around.begin(), around.end());
    for (size_t begin = 0, end = 0; begin < around.size(); begin = end) {
      int balance = 0;
      for (; end < around.size() && around[end].first == around[begin].first; ++end)
        balance += around[end].second;
      if (balance != 0) note(around[begin].first);
    }
  }

  bool goes_up(uint32_t side) const {
    const auto& t = triangles_[side / 3];
    return t[side % 3] < t[(side % 3 + 1) % 3];
  }

  const std::vector<std::array<uint32_t, 3>>& triangles_;
  const SoupEdges& edges_;
  const Progress* progress_;
  Patches patches_;
  std::vector<uint32_t>& patch_of_;
  uint32_t patch_count_ = 0;
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

Result<Patches> find_patches(const std::vector<std::array<uint32_t, 3>>& triangles, const SoupEdges& edges,
                             const Progress* progress) {
  KERF_ASSERT(edges.triangles() == triangles.size());
  return PatchFinder(triangles, edges, progress).run();
}

size_t count_components(const Patches& patches, const SoupEdges& edges) {
  KERF_ASSERT(patches.patch_of.size() == edges.triangles());
  size_t components = patches.count();
  if (components == 1) return 1;
  UnionFind sets(patches.count());
  for (uint32_t e = 0; e < edges.count(); ++e) {
    const auto sides = edges.sides_of(e);
    if (sides.size() < 3) continue;
    for (const uint32_t side : sides)
      components -= sets.unite(patches.patch_of[sides[0] / 3], patches.patch_of[side / 3]);
  }
  return components;
}

}  // namespace kerf
