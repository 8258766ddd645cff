#include "core/cut/swept_distance.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr size_t kMostOfLeaf = 4;
constexpr size_t kDeepest = 64;  // more halvings than there can be

}  // namespace

SweptDistance::SweptDistance(const StrokeRegion& region, std::span<const BeamMove> moves) {
  KERF_ASSERT(region.parts() == moves.size() && !moves.empty());
  for (size_t i = 0; i < region.parts(); ++i) parts_.push_back(region.part(i));
  nodes_.push_back({0, moves.size(), {}, {}});
  for (uint32_t i = 0; i < nodes_.size(); ++i) {
    bound(i, moves);
    const auto [first, end] = std::pair(nodes_[i].first, nodes_[i].end);
    if (end - first <= kMostOfLeaf) continue;
    nodes_[i].halves = static_cast<uint32_t>(nodes_.size());
    const size_t middle = first + (end - first) / 2;
    nodes_.push_back({first, middle, {}, {}});
    nodes_.push_back({middle, end, {}, {}});
  }
}

void SweptDistance::bound(uint32_t node, std::span<const BeamMove> moves) {
  Node& n = nodes_[node];
  const Pose& middle = moves[n.first + (n.end - n.first) / 2].from;
  n.origin = middle.origin;
  n.direction = middle.direction;
  for (const BeamMove& m : moves.subspan(n.first, n.end - n.first)) {
    for (const Pose* pose : {&m.from, &m.to}) {
      n.aside = std::max(n.aside, glm::length(pose->origin - n.origin));
      n.apart = std::max(n.apart, glm::length(pose->direction - n.direction));
    }
  }
}

// A bound of the distances from the parts of a node.
double SweptDistance::at_least(const Node& node, const Vec3& p) const {
  constexpr double kRounding = 1e-9;  // beside which the parts of a beam that tilts err by the angle squared
  const Vec3 from = p - node.origin;
  const double away = glm::length(from);
  const double from_axis = glm::length(from - glm::dot(from, node.direction) * node.direction);
  const double aside = node.aside + node.apart * (1 + node.apart) * (away + node.aside);
  return from_axis - aside - parts_[node.first].radius() - kRounding * (away + node.aside);
}

double SweptDistance::operator()(const Vec3& p) const {
  struct Visit {
    double at_least;
    uint32_t node;
  };
  std::array<Visit, kDeepest> stack;
  size_t waiting = 0;
  stack[waiting++] = {-std::numeric_limits<double>::infinity(), 0};
  double least = std::numeric_limits<double>::infinity();
  while (waiting > 0) {
    const Visit visit = stack[--waiting];
    if (visit.at_least >= least) continue;
    const Node& node = nodes_[visit.node];
    if (node.halves == 0) {
      for (size_t i = node.first; i < node.end; ++i) least = std::min(least, parts_[i].signed_distance(p));
      continue;
    }
    Visit nearer{at_least(nodes_[node.halves], p), node.halves};
    Visit farther{at_least(nodes_[node.halves + 1], p), node.halves + 1};
    if (farther.at_least < nearer.at_least) std::swap(nearer, farther);
    KERF_ASSERT(waiting + 2 <= kDeepest);
    stack[waiting++] = farther;
    stack[waiting++] = nearer;
  }
  return least;
}

}  // namespace kerf
