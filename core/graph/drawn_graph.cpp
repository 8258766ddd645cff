#include "core/graph/drawn_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/assert.h"
#include "core/base/containers.h"
#include "core/base/deterministic_math.h"
#include "core/base/principal_axes.h"
#include "core/base/random.h"

namespace kerf {

namespace {

constexpr int kTurns = 120;       // iterations of the forces
constexpr double kJitter = 1e-3;  // of the side of the layout, so that no two nodes coincide

std::vector<Vec3> middles_of(const DrawnGraph& graph, bool only_removed) {
  std::vector<Vec3> middles;
  for (const DrawnGraph::Node& n : graph.nodes) {
    if (n.removed || !only_removed) middles.push_back(n.middle);
  }
  return middles;
}

// Scales a layout to the square [-1, 1]^2.
void fit(GraphLayout& places) {
  if (places.empty()) return;
  Vec2 low = places[0], high = places[0];
  for (const Vec2& p : places) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double side = std::max(high.x - low.x, high.y - low.y);
  const Vec2 middle = 0.5 * (low + high);
  for (Vec2& p : places) p = side > 0 ? (p - middle) * (2 / side) : Vec2(0);
}

// A grid of square cells of nodes, to find nearby ones.
class Cells {
 public:
  static constexpr int kMaxCells = 64;  // a side

  // Covers all places by cells of at least this width. Precondition: there is a place, and width > 0.
  Cells(const GraphLayout& places, double width) {
    KERF_ASSERT(!places.empty() && width > 0);
    low_ = places[0];
    Vec2 high = places[0];
    for (const Vec2& p : places) {
      low_ = glm::min(low_, p);
      high = glm::max(high, p);
    }
    width_ = std::max(width, std::max(high.x - low_.x, high.y - low_.y) / kMaxCells);
    in_.resize(size_t{kMaxCells} * kMaxCells);
    for (uint32_t i = 0; i < places.size(); ++i)
      in_[at(column(places[i].x, low_.x), column(places[i].y, low_.y))].push_back(i);
  }

  // Calls visit(node) for all nodes nearer to a place than the width of a cell, and some others.
  template <typename Visit>
  void for_each_near(const Vec2& place, const Visit& visit) const {
    const int x = column(place.x, low_.x), y = column(place.y, low_.y);
    for (int v = std::max(0, y - 1); v <= std::min(kMaxCells - 1, y + 1); ++v) {
      for (int u = std::max(0, x - 1); u <= std::min(kMaxCells - 1, x + 1); ++u) {
        for (const uint32_t node : in_[at(u, v)]) visit(node);
      }
    }
  }

 private:
  int column(double x, double low) const {
    return std::clamp(static_cast<int>((x - low) / width_), 0, kMaxCells - 1);
  }
  static size_t at(int x, int y) { return static_cast<size_t>(y) * kMaxCells + static_cast<size_t>(x); }

  Vec2 low_{0};
  double width_ = 1;
  std::vector<std::vector<uint32_t>> in_;
};

class Forces {
 public:
  Forces(const DrawnGraph& graph, GraphLayout& places)
      : graph_(graph),
        places_(places),
        force_(places.size()),
        spring_(2 / std::sqrt(static_cast<double>(places.size()))) {
    KERF_ASSERT(places.size() == graph.nodes.size());
  }

  // Moves each node by its force, at most by `farthest`.
  void turn(double farthest) {
    std::fill(force_.begin(), force_.end(), Vec2(0));
    const Cells cells(places_, 2 * spring_);
    for (uint32_t i = 0; i < places_.size(); ++i)
      cells.for_each_near(places_[i], [&](uint32_t k) { repel(i, k); });
    attract();
    for (size_t i = 0; i < places_.size(); ++i) {
      const double length = glm::length(force_[i]);
      if (length > 0) places_[i] += force_[i] * (std::min(length, farthest) / length);
    }
  }

 private:
  void repel(uint32_t i, uint32_t k) {
    const Vec2 away = places_[i] - places_[k];
    const double distance2 = glm::dot(away, away);
    if (i == k || !(distance2 > 0) || distance2 > 4 * spring_ * spring_) return;
    force_[i] += away * (spring_ * spring_ / distance2);
  }

  void attract() {
    for (const auto& [a, b] : graph_.edges) {
      const Vec2 to = places_[b] - places_[a];
      const Vec2 pull = to * (glm::length(to) / spring_);
      force_[a] += pull;
      force_[b] -= pull;
    }
  }

  const DrawnGraph& graph_;
  GraphLayout& places_;
  std::vector<Vec2> force_;
  double spring_;
};

// A ring around the middle of the removed faces, in the plane in which these extend most.
class Ring {
 public:
  explicit Ring(const std::vector<Vec3>& removed)
      : middle_(mean_of(removed)), directions_(principal_axes(removed, middle_)) {
    KERF_ASSERT(!removed.empty());
    for (const Vec3& p : removed) {
      turns_.push_back(doubled_area(p));
      radius_ += glm::length(flat(p)) / static_cast<double>(removed.size());
    }
    for (const Vec3& p : removed) inside_ += glm::length(flat(p)) < kInside * radius_ ? 1 : 0;
    std::sort(turns_.begin(), turns_.end());
    for (size_t i = 0; i < turns_.size(); ++i) {
      const double next = i + 1 < turns_.size() ? turns_[i + 1] : turns_.front() + kTurn;
      if (next - turns_[i] <= gap_) continue;
      gap_ = next - turns_[i];
      seam_ = turns_[i] + 0.5 * gap_;
    }
  }

  // Returns true if the removed faces run around: the widest gap between them is less than a quarter turn,
  // and few of them are near the middle, through which a cut across a sheet runs.
  bool is_round() const {
    return radius_ > 0 && gap_ < kTurn / 4 &&
           static_cast<double>(inside_) < 0.05 * static_cast<double>(turns_.size());
  }
  // Returns the position of a point on the unrolled ring in radii: path from the seam, signed distance.
  Vec2 unrolled(const Vec3& p) const {
    double turn = doubled_area(p) - seam_;
    while (turn < 0) turn += kTurn;
    while (turn >= kTurn) turn -= kTurn;
    const double up = glm::dot(p - middle_, directions_[2]), off = glm::length(flat(p)) - radius_;
    const double away = std::sqrt(up * up + off * off) / radius_;
    return {kCircle * turn / kTurn, up < 0 ? -away : away};
  }

 private:
  static constexpr double kTurn = 4;      // of an angle as doubled_area() measures it
  static constexpr double kInside = 0.3;  // of the mean radius
  static constexpr double kCircle = 2 * kPi;

  Vec2 flat(const Vec3& p) const {
    return {glm::dot(p - middle_, directions_[0]), glm::dot(p - middle_, directions_[1])};
  }
  // From 0 to kTurn, monotone in the angle and equal to it, in quarter turns, at multiples of an eighth.
  double doubled_area(const Vec3& p) const {
    const Vec2 v = flat(p);
    const double size = std::abs(v.x) + std::abs(v.y);
    if (!(size > 0)) return 0;
    const double quarter = v.y / size;
    if (v.x < 0) return 2 - quarter;
    return quarter < 0 ? kTurn + quarter : quarter;
  }

  Vec3 middle_;
  std::array<Vec3, 3> directions_;
  std::vector<double> turns_;
  double radius_ = 0, gap_ = 0, seam_ = 0;
  size_t inside_ = 0;  // removed faces near the middle
};

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
  KERF_ASSERT(traversal.set.size() == graph.live && graph.live <= graph.nodes.size());
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
class NodeClustering {
 public:
  NodeClustering(const CutGraph& graph, std::vector<uint32_t> kind)
      : graph_(graph), kind_(std::move(kind)), of_(graph.nodes.size(), kNoIndex) {}

  void divide(const std::vector<uint32_t>& nodes, size_t most) {
    const Selection selection(graph_, nodes);
    const std::vector<uint32_t> clusters = selection.clusters(kind_, most);
    KERF_ASSERT(clusters.size() == selection.nodes().size());
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
std::vector<bool> largest(const NodeClustering& clustering) {
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
void divide_by_zones(NodeClustering& clustering, const CutGraph& graph, const std::vector<uint32_t>& nodes) {
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

std::optional<GraphLayout> lay_out_unrolled(const DrawnGraph& graph) {
  constexpr double kMinHeight = 0.4;  // of the width
  const std::vector<Vec3> removed = middles_of(graph, true);
  if (removed.size() < 3) return std::nullopt;
  const Ring ring(removed);
  if (!ring.is_round()) return std::nullopt;
  GraphLayout places;
  double width = 0, height = 0;
  for (const DrawnGraph::Node& n : graph.nodes) {
    places.push_back(ring.unrolled(n.middle));
    width = std::max(width, places.back().x);
    height = std::max(height, 2 * std::abs(places.back().y));
  }
  const double stretch = height > 0 ? std::max(1.0, kMinHeight * width / height) : 1;
  for (Vec2& p : places) p.y *= stretch;
  fit(places);
  return places;
}

GraphLayout lay_out_by_position(const DrawnGraph& graph) {
  const std::vector<Vec3> middles = middles_of(graph, false);
  const Vec3 mean = mean_of(middles);
  const std::array<Vec3, 3> directions = principal_axes(middles, mean);
  GraphLayout places;
  for (const DrawnGraph::Node& n : graph.nodes)
    places.emplace_back(glm::dot(n.middle - mean, directions[0]), glm::dot(n.middle - mean, directions[1]));
  fit(places);
  return places;
}

GraphLayout lay_out_by_force(const DrawnGraph& graph) {
  GraphLayout places = lay_out_by_position(graph);
  if (places.empty()) return places;
  Random random(1);
  for (Vec2& p : places) {
    // Not as arguments of one call, whose order differs between compilers.
    const double y = random.uniform(-1, 1), x = random.uniform(-1, 1);
    p += kJitter * Vec2(x, y);
  }
  Forces forces(graph, places);
  for (int i = 0; i < kTurns; ++i) forces.turn(0.1 * (kTurns - i) / kTurns);
  fit(places);
  return places;
}

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
  NodeClustering clustering(graph, kinds_of(graph, traversal));
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
