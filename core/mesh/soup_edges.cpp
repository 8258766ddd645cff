#include "core/mesh/soup_edges.h"

#include <algorithm>
#include <cassert>

#include "core/base/union_find.h"

namespace kerf {

namespace {

struct Side {
  uint32_t high;  // the greater of its two vertices
  uint32_t side;
  friend bool operator<(const Side& a, const Side& b) {
    return a.high != b.high ? a.high < b.high : a.side < b.side;
  }
};

}  // namespace

Result<SoupEdges> group_sides(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices,
                              const Progress* progress) {
  // Counting sort by the lesser vertex, then each bucket by the greater one.
  std::vector<uint32_t> bucket(vertices + 1, 0);
  const auto ends = [&](uint32_t side) {
    const uint32_t a = triangles[side / 3][side % 3], b = triangles[side / 3][(side % 3 + 1) % 3];
    assert(a != b && std::max(a, b) < vertices);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  const uint32_t side_count = static_cast<uint32_t>(3 * triangles.size());
  Stages stages(progress);
  const Progress counting = stages.next(0.15), placing = stages.next(0.25), sorting = stages.next(0.6);
  Pace count_pace(&counting, side_count);
  for (uint32_t s = 0; s < side_count; ++s) {
    if (!count_pace.step()) return cancelled();
    ++bucket[ends(s).first + 1];
  }
  for (size_t v = 0; v < vertices; ++v) bucket[v + 1] += bucket[v];
  std::vector<Side> sorted(side_count);
  std::vector<uint32_t> next(bucket.begin(), bucket.end() - 1);
  Pace place_pace(&placing, side_count);
  for (uint32_t s = 0; s < side_count; ++s) {
    if (!place_pace.step()) return cancelled();
    const auto [low, high] = ends(s);
    sorted[next[low]++] = {high, s};
  }

  SoupEdges edges;
  edges.sides.reserve(side_count);
  edges.edge_of.resize(side_count);
  edges.first.reserve(side_count / 2 + 1);
  Pace sort_pace(&sorting, vertices);
  for (size_t v = 0; v < vertices; ++v) {
    if (!sort_pace.step()) return cancelled();
    std::sort(sorted.begin() + bucket[v], sorted.begin() + bucket[v + 1]);
    for (uint32_t i = bucket[v]; i < bucket[v + 1]; ++i) {
      if (i == bucket[v] || sorted[i].high != sorted[i - 1].high) edges.first.push_back(i);
      edges.sides.push_back(sorted[i].side);
      edges.edge_of[sorted[i].side] = static_cast<uint32_t>(edges.first.size() - 1);
    }
  }
  edges.first.push_back(side_count);
  return edges;
}

SoupEdges group_sides(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices) {
  return std::move(*group_sides(triangles, vertices, nullptr));
}

size_t count_components(const SoupEdges& edges) {
  const size_t triangles = edges.edge_of.size() / 3;
  UnionFind sets(triangles);
  size_t components = triangles;
  for (uint32_t e = 0; e < edges.count(); ++e) {
    const auto sides = edges.sides_of(e);
    for (size_t i = 1; i < sides.size(); ++i) components -= sets.unite(sides[0] / 3, sides[i] / 3);
  }
  return components;
}

}  // namespace kerf
