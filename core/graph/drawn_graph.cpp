#include "core/graph/drawn_graph.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/assert.h"
#include "core/base/containers.h"

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

// Returns the smallest linked cluster of the same kind, kNoIndex if there is none.
uint32_t best_partner(const Round& round, UnionFind& joined, std::span<const uint32_t> size,
                      uint32_t cluster) {
  uint32_t best = kNoIndex;
  for (const uint32_t other : round.links.of(cluster)) {
    if (round.kind[other] != round.kind[cluster] || joined.find(other) == joined.find(cluster)) continue;
    if (best == kNoIndex || size[joined.find(other)] < size[joined.find(best)]) best = other;
  }
  return best;
}

// Joins each cluster with another one, the smallest first, until `most` are left. Returns their number.
size_t join_pairs(const Round& round, UnionFind& joined, size_t most) {
  const auto count = static_cast<uint32_t>(round.size.size());
  std::vector<uint32_t> order(count), size = round.size;
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return round.size[a] < round.size[b]; });
  size_t left = count;
  for (uint32_t i = 0; i < count && left > most; ++i) {
    const uint32_t cluster = order[i];
    if (size[joined.find(cluster)] > round.size[cluster]) continue;  // already joined in this round
    const uint32_t other = best_partner(round, joined, size, cluster);
    if (other == kNoIndex) continue;
    const uint32_t both = size[joined.find(cluster)] + size[joined.find(other)];
    joined.unite(cluster, other);
    size[joined.find(cluster)] = both;
    --left;
  }
  return left;
}

// Returns the next round, with the joined clusters as nodes.
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

namespace {

constexpr uint32_t kRemovedKind = kNoIndex - 1;

// Nodes of a graph to be clustered on their own.
class Selection {
 public:
  Selection(const CutGraph& graph, std::vector<uint32_t> nodes) : nodes_(std::move(nodes)) {
    std::sort(nodes_.begin(), nodes_.end());
    std::vector<uint32_t> local(graph.nodes.size(), kNoIndex);
    for (size_t i = 0; i < nodes_.size(); ++i) local[nodes_[i]] = static_cast<uint32_t>(i);
    std::vector<ComponentGraph::Edge> edges;
    for (const auto& [a, b] : graph.edges) {
      if (local[a] != kNoIndex && local[b] != kNoIndex) edges.push_back({local[a], local[b]});
    }
    links_ = GraphLinks(nodes_.size(), edges);
  }

  const std::vector<uint32_t>& nodes() const { return nodes_; }

  std::vector<uint32_t> clusters(const std::vector<uint32_t>& kind_of, size_t most) const {
    std::vector<uint32_t> kind;
    for (const uint32_t node : nodes_) kind.push_back(kind_of[node]);
    return cluster_nodes(links_, kind, most);
  }

 private:
  std::vector<uint32_t> nodes_;
  GraphLinks links_;
};

std::vector<uint32_t> kinds_of(const CutGraph& graph, const CutTraversal& traversal) {
  std::vector<uint32_t> kind(graph.nodes.size(), kRemovedKind);
  std::copy(traversal.set.begin(), traversal.set.end(), kind.begin());
  return kind;
}

std::vector<uint32_t> all_of(const CutGraph& graph) {
  std::vector<uint32_t> all(graph.nodes.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

// Returns the removed faces and those around them, breadth-first.
std::vector<uint32_t> around_cut(const CutGraph& graph) {
  const size_t removed = graph.nodes.size() - graph.live;
  if (removed == 0) return all_of(graph);
  const size_t most = std::max(DrawnGraph::kMost, 2 * removed);
  const GraphLinks links = graph.links();
  std::vector<uint32_t> selected(removed);
  std::iota(selected.begin(), selected.end(), graph.live);
  std::vector<bool> seen(graph.nodes.size(), false);
  for (const uint32_t node : selected) seen[node] = true;
  for (size_t i = 0; i < selected.size(); ++i) {
    for (const uint32_t other : links.of(selected[i])) {
      if (seen[other] || selected.size() >= most) continue;
      seen[other] = true;
      selected.push_back(other);
    }
  }
  return selected;
}

// Divides nodes into clusters, some of which are opened.
class Clustering {
 public:
  Clustering(const CutGraph& graph, std::vector<uint32_t> kind)
      : graph_(graph), kind_(std::move(kind)), of_(graph.nodes.size(), kNoIndex) {}

  void divide(const std::vector<uint32_t>& nodes, size_t most) {
    const Selection selection(graph_, nodes);
    const std::vector<uint32_t> clusters = selection.clusters(kind_, most);
    const uint32_t first = next_;
    for (size_t i = 0; i < clusters.size(); ++i) {
      of_[selection.nodes()[i]] = first + clusters[i];
      next_ = std::max(next_, first + clusters[i] + 1);
    }
    count_ += next_ - first;
  }

  void open(uint32_t node) {
    if (node >= of_.size() || of_[node] == kNoIndex || count_ > DrawnGraph::kMost) return;
    std::vector<uint32_t> members;
    for (uint32_t other = 0; other < of_.size(); ++other) {
      if (of_[other] == of_[node]) members.push_back(other);
    }
    --count_;
    divide(members, DrawnGraph::kMost - count_);
  }

  const std::vector<uint32_t>& of() const { return of_; }
  uint32_t numbers() const { return next_; }
  size_t count() const { return count_; }

 private:
  const CutGraph& graph_;
  std::vector<uint32_t> kind_, of_;
  uint32_t next_ = 0;
  size_t count_ = 0;
};

// Returns by cluster whether it is among the kMost largest; ties go to the lower number.
std::vector<bool> largest(const Clustering& clustering) {
  std::vector<uint32_t> size(clustering.numbers(), 0), order(clustering.numbers());
  for (const uint32_t cluster : clustering.of()) {
    if (cluster != kNoIndex) ++size[cluster];
  }
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return size[a] > size[b]; });
  std::vector<bool> drawn(size.size(), false);
  for (size_t i = 0; i < std::min(DrawnGraph::kMost, order.size()); ++i) drawn[order[i]] = true;
  return drawn;
}

void add_face(DrawnGraph::Node& drawn, const CutGraph& graph, const CutTraversal& traversal, uint32_t node) {
  ++drawn.faces;
  drawn.middle += (graph.middles[node] - drawn.middle) / static_cast<double>(drawn.faces);
  drawn.removed = graph.is_removed(node);
  if (drawn.removed) {
    drawn.removed_at = std::min(drawn.removed_at, node - graph.live);
    return;
  }
  drawn.set = traversal.set[node];
  drawn.marked_at = std::min(drawn.marked_at, traversal.traversal.rank[node]);
}

std::vector<ComponentGraph::Edge> edges_between(const CutGraph& graph, const std::vector<uint32_t>& of) {
  std::vector<ComponentGraph::Edge> edges;
  for (const auto& [a, b] : graph.edges) {
    if (of[a] == kNoIndex || of[b] == kNoIndex || of[a] == of[b]) continue;
    edges.push_back({std::min(of[a], of[b]), std::max(of[a], of[b])});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// The nodes of the scope by zone: removed, live next to a removed one, and the others.
using Zones = std::array<std::vector<uint32_t>, 3>;
Zones zones_of(const CutGraph& graph, const std::vector<uint32_t>& nodes) {
  std::vector<bool> beside(graph.nodes.size(), false);
  for (const auto& [a, b] : graph.edges) {
    if (graph.is_removed(b)) beside[a] = true;  // b is the higher node
  }
  Zones zones;
  for (const uint32_t node : nodes)
    zones.at(graph.is_removed(node) ? 0 : beside[node] ? 1 : 2).push_back(node);
  return zones;
}

// Divides the nodes of an oversized scope. Each zone passes its unused share to the next.
void divide_by_zones(Clustering& clustering, const CutGraph& graph, const std::vector<uint32_t>& nodes) {
  const Zones zones = zones_of(graph, nodes);
  size_t left = DrawnGraph::kMost / 2, shares = 5;
  for (size_t zone = 0; zone < zones.size(); ++zone) {
    const size_t share = zone == 0 ? 1 : 2;
    const size_t most = zone + 1 < zones.size() ? left * share / shares : left;
    const size_t before = clustering.count();
    if (!zones[zone].empty()) clustering.divide(zones[zone], most);
    left -= std::min(left, clustering.count() - before);
    shares -= share;
  }
}

}  // namespace

Vec3 DrawnGraph::moved_with(BodyId body, const Vec3& point, const World& world) const {
  const auto found = placements.find(body);
  if (found == placements.end() || !world.contains(body)) return point;
  const Placement& now = world.body(body).placement;
  return now == found->second ? point : now.to_world(found->second.to_body(point));
}

DrawnGraph::State DrawnGraph::state(const Node& node) const {
  if (node.removed) return node.removed_at < removals ? State::kRemoved : State::kUnmarked;
  if (node.marked_at < marked) return State::kMarked;
  const bool over = marked >= reached;
  return over && node.set != kNoIndex ? State::kApart : State::kUnmarked;
}

bool DrawnGraph::is_cut(const ComponentGraph::Edge& edge) const {
  return state(nodes[edge[0]]) == State::kRemoved || state(nodes[edge[1]]) == State::kRemoved;
}

DrawnGraph draw_graph(const CutGraph& graph, const CutTraversal& traversal, GraphScope scope,
                      std::span<const uint32_t> opened) {
  const std::vector<uint32_t> nodes = scope == GraphScope::kWhole ? all_of(graph) : around_cut(graph);
  Clustering clustering(graph, kinds_of(graph, traversal));
  if (nodes.size() > DrawnGraph::kMost) {
    divide_by_zones(clustering, graph, nodes);
  } else {
    clustering.divide(nodes, DrawnGraph::kMost);
  }
  for (const uint32_t node : opened) clustering.open(node);
  const std::vector<bool> is_drawn = largest(clustering);
  DrawnGraph drawn;
  drawn.of.assign(graph.nodes.size(), kNoIndex);
  std::vector<uint32_t> number(clustering.numbers(), kNoIndex);
  for (uint32_t node = 0; node < graph.nodes.size(); ++node) {
    const uint32_t cluster = clustering.of()[node];
    if (cluster == kNoIndex || !is_drawn[cluster]) continue;
    if (number[cluster] == kNoIndex) {
      number[cluster] = static_cast<uint32_t>(drawn.nodes.size());
      drawn.nodes.emplace_back();
      drawn.nodes.back().lowest = node;
      drawn.nodes.back().face = graph.nodes[node];
    }
    drawn.of[node] = number[cluster];
    add_face(drawn.nodes[number[cluster]], graph, traversal, node);
  }
  drawn.edges = edges_between(graph, drawn.of);
  drawn.placements = graph.placements;
  drawn.reached = traversal.reached();
  return drawn;
}

}  // namespace kerf
