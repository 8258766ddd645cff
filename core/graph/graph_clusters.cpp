#include "core/graph/graph_clusters.h"

#include <algorithm>
#include <numeric>

#include "core/base/assert.h"
#include "core/base/union_find.h"

namespace kerf {

namespace {

// The clusters of one round, numbered in the order of their lowest nodes.
struct Round {
  std::vector<uint32_t> of, size, kind;
  GraphLinks links;
};

std::vector<ComponentGraph::Edge> edges_between(const GraphLinks& links, const std::vector<uint32_t>& of) {
  std::vector<ComponentGraph::Edge> edges;
  for (uint32_t node = 0; node < links.nodes(); ++node) {
    for (const uint32_t other : links.of(node)) {
      if (of[node] < of[other]) edges.push_back({of[node], of[other]});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// The linked cluster of the same kind to join: the smallest one, kNoIndex if there is none.
uint32_t best_partner(const Round& round, UnionFind& joined, std::span<const uint32_t> size,
                      uint32_t cluster) {
  uint32_t best = kNoIndex;
  for (const uint32_t other : round.links.of(cluster)) {
    if (round.kind[other] != round.kind[cluster] || joined.find(other) == joined.find(cluster)) continue;
    if (best == kNoIndex || size[joined.find(other)] < size[joined.find(best)]) best = other;
  }
  return best;
}

// Joins each cluster with another one, the smallest first, until `most` are left. Returns how many are left.
size_t join_pairs(const Round& round, UnionFind& joined, size_t most) {
  const auto count = static_cast<uint32_t>(round.size.size());
  std::vector<uint32_t> order(count), size = round.size;
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return round.size[a] < round.size[b]; });
  size_t left = count;
  for (uint32_t i = 0; i < count && left > most; ++i) {
    const uint32_t cluster = order[i];
    if (size[joined.find(cluster)] > round.size[cluster]) continue;  // was joined in this round
    const uint32_t other = best_partner(round, joined, size, cluster);
    if (other == kNoIndex) continue;
    const uint32_t both = size[joined.find(cluster)] + size[joined.find(other)];
    joined.unite(cluster, other);
    size[joined.find(cluster)] = both;
    --left;
  }
  return left;
}

// The round after one in which clusters were joined.
Round next_round(const GraphLinks& links, const Round& round, UnionFind& joined) {
  Round next;
  std::vector<uint32_t> number(round.size.size(), kNoIndex);
  next.of.resize(round.of.size());
  for (size_t node = 0; node < round.of.size(); ++node) {
    const uint32_t before = round.of[node];
    uint32_t& after = number[joined.find(before)];
    if (after == kNoIndex) {
      after = static_cast<uint32_t>(next.size.size());
      next.size.push_back(0);
      next.kind.push_back(round.kind[before]);
    }
    next.of[node] = after;
    ++next.size[after];
  }
  next.links = GraphLinks(next.size.size(), edges_between(links, next.of));
  return next;
}

}  // namespace

std::vector<uint32_t> cluster_nodes(const GraphLinks& links, std::span<const uint32_t> kind, size_t most) {
  KERF_ASSERT(kind.size() == links.nodes());
  Round round;
  round.of.resize(links.nodes());
  std::iota(round.of.begin(), round.of.end(), 0u);
  round.size.assign(links.nodes(), 1);
  round.kind.assign(kind.begin(), kind.end());
  round.links = links;
  while (round.size.size() > most) {
    UnionFind joined(round.size.size());
    if (join_pairs(round, joined, most) == round.size.size()) break;
    round = next_round(links, round, joined);
  }
  return std::move(round.of);
}

}  // namespace kerf
