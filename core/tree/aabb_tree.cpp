#include "core/tree/aabb_tree.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/base/tolerances.h"

namespace kerf {

namespace {

// The next float below or above, for finite numbers.
float step(float x, bool up) {
  if (x == 0.0f)
    return up ? std::numeric_limits<float>::denorm_min() : -std::numeric_limits<float>::denorm_min();
  const uint32_t bits = std::bit_cast<uint32_t>(x);
  return std::bit_cast<float>((x > 0) == up ? bits + 1 : bits - 1);
}
float round_down(double x) {
  const float f = static_cast<float>(x);
  return f > x ? step(f, false) : f;
}
float round_up(double x) {
  const float f = static_cast<float>(x);
  return f < x ? step(f, true) : f;
}

// The largest power of two that is at most x; x > 0 and finite.
double power_of_two_below(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(1.0, exponent - 1);
}

}  // namespace

// A face on its way into a tree that is being built: its box's centre, and its number.
struct AabbTree::Span {
  Vec3 centre;
  FaceId face;
};

AabbTree::AabbTree(const Mesh& mesh) {
  set_frame(mesh);
  leaf_of_.assign(mesh.face_slots(), kNone);
  std::vector<Span> spans;
  spans.reserve(mesh.live_faces());
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    const Triangle t = mesh.triangle(FaceId(f));
    const Vec3 low = glm::min(t[0], glm::min(t[1], t[2])), high = glm::max(t[0], glm::max(t[1], t[2]));
    spans.push_back({scale_ * (0.5 * (low - origin_) + 0.5 * (high - origin_)), FaceId(f)});
  }
  if (spans.empty()) return;
  nodes_.reserve(2 * spans.size() + spans.size() / 4);
  leaf_count_ = spans.size();
  root_ = build(mesh, spans, 0, spans.size(), kNone);
}

void AabbTree::set_frame(const Mesh& mesh) {
  Vec3 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    for (const Vec3& p : mesh.triangle(FaceId(f))) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  if (low.x > high.x) return;
  origin_ = 0.5 * low + 0.5 * high;
  const Vec3 half = high - origin_;
  const double extent = std::max({half.x, half.y, half.z});
  scale_ = extent > 0 ? 1.0 / power_of_two_below(extent) : 1.0;
}

uint32_t AabbTree::build(const Mesh& mesh, std::vector<Span>& spans, size_t begin, size_t end,
                         uint32_t parent) {
  const uint32_t n = new_node();
  nodes_[n].parent = parent;
  if (end - begin == 1) {
    nodes_[n].child = {spans[begin].face.index, kNone};
    set_leaf(spans[begin].face, n);
    fit_leaf(mesh, nodes_[n]);
    return n;
  }
  Vec3 low = spans[begin].centre, high = low;
  for (size_t i = begin; i < end; ++i) {
    low = glm::min(low, spans[i].centre);
    high = glm::max(high, spans[i].centre);
  }
  const Vec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const size_t middle = begin + (end - begin) / 2;
  std::nth_element(spans.begin() + begin, spans.begin() + middle, spans.begin() + end,
                   [axis](const Span& a, const Span& b) {
                     return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis]
                                                             : a.face < b.face;
                   });
  const uint32_t left = build(mesh, spans, begin, middle, n), right = build(mesh, spans, middle, end, n);
  nodes_[n].child = {left, right};
  fit_parent(nodes_[n]);
  return n;
}

void AabbTree::fit_leaf(const Mesh& mesh, Node& node) const {
  const Triangle t = mesh.triangle(FaceId(node.child[0]));
  const Vec3 low = glm::min(t[0], glm::min(t[1], t[2])), high = glm::max(t[0], glm::max(t[1], t[2]));
  for (int k = 0; k < 3; ++k) {
    node.low[k] = round_down((low[k] - origin_[k]) * scale_);
    node.high[k] = round_up((high[k] - origin_[k]) * scale_);
  }
}

void AabbTree::fit_parent(Node& node) const {
  const Node &a = nodes_[node.child[0]], &b = nodes_[node.child[1]];
  for (int k = 0; k < 3; ++k) {
    node.low[k] = std::min(a.low[k], b.low[k]);
    node.high[k] = std::max(a.high[k], b.high[k]);
  }
}

uint32_t AabbTree::new_node() {
  if (free_.empty()) {
    nodes_.emplace_back();
    return static_cast<uint32_t>(nodes_.size() - 1);
  }
  const uint32_t n = free_.back();
  free_.pop_back();
  nodes_[n] = Node{};
  return n;
}

void AabbTree::free_node(uint32_t n) { free_.push_back(n); }

void AabbTree::set_leaf(FaceId f, uint32_t node) {
  if (f.index >= leaf_of_.size()) leaf_of_.resize(f.index + 1, kNone);
  leaf_of_[f.index] = node;
}

// Builds a small balanced tree over the faces, in their order, in the node `at` (or a new one).
uint32_t AabbTree::graft(const Mesh& mesh, std::span<const FaceId> faces, uint32_t parent, uint32_t at) {
  const uint32_t n = at != kNone ? at : new_node();
  nodes_[n].parent = parent;
  if (faces.size() == 1) {
    nodes_[n].child = {faces[0].index, kNone};
    set_leaf(faces[0], n);
    fit_leaf(mesh, nodes_[n]);
    return n;
  }
  const size_t half = faces.size() / 2;
  const uint32_t left = graft(mesh, faces.first(half), n, kNone);
  const uint32_t right = graft(mesh, faces.subspan(half), n, kNone);
  nodes_[n].child = {left, right};
  fit_parent(nodes_[n]);
  return n;
}

void AabbTree::replace(const Mesh& mesh, std::span<const FaceId> gone, std::span<const FaceId> born) {
  assert(gone.size() == 1 || gone.size() == 2);
  uint32_t at = leaf_of_[gone[0].index];
  if (gone.size() == 2) {
    const uint32_t other = leaf_of_[gone[1].index];
    assert(nodes_[at].parent == nodes_[other].parent);
    const uint32_t above = nodes_[at].parent;
    free_node(at);
    free_node(other);
    at = above;
  }
  for (const FaceId f : gone) leaf_of_[f.index] = kNone;
  graft(mesh, born, nodes_[at].parent, at);
  leaf_count_ += born.size() - gone.size();
  grow_from(nodes_[at].parent);
}

// Refits the boxes from n upward for as long as they do not hold their children: a split face may have been
// split again by the time the tree hears of it.
void AabbTree::refit(const Mesh& mesh, std::span<const FaceId> faces) {
  for (const FaceId f : faces) {
    Node& leaf = nodes_[leaf_of_[f.index]];
    fit_leaf(mesh, leaf);
    grow_from(leaf.parent);
  }
}

void AabbTree::grow_from(uint32_t n) {
  for (; n != kNone; n = nodes_[n].parent) {
    Node fitted = nodes_[n];
    fit_parent(fitted);
    const Node& held = nodes_[n];
    bool holds = true;
    for (int k = 0; k < 3; ++k)
      holds = holds && held.low[k] <= fitted.low[k] && held.high[k] >= fitted.high[k];
    if (holds) return;
    nodes_[n] = fitted;
  }
}

void AabbTree::remove(FaceId f) {
  const uint32_t leaf = leaf_of_[f.index];
  assert(leaf != kNone);
  leaf_of_[f.index] = kNone;
  --leaf_count_;
  const uint32_t parent = nodes_[leaf].parent;
  free_node(leaf);
  if (parent == kNone) {
    root_ = kNone;
    return;
  }
  // The sibling takes its parent's place.
  const uint32_t sibling = nodes_[parent].child[nodes_[parent].child[0] == leaf];
  const uint32_t above = nodes_[parent].parent;
  nodes_[sibling].parent = above;
  free_node(parent);
  if (above == kNone) {
    root_ = sibling;
    return;
  }
  nodes_[above].child[nodes_[above].child[1] == parent] = sibling;
  shrink_from(above);
}

// Refits the boxes from n upward for as long as they change.
void AabbTree::shrink_from(uint32_t n) {
  for (; n != kNone; n = nodes_[n].parent) {
    const auto low = nodes_[n].low, high = nodes_[n].high;
    fit_parent(nodes_[n]);
    if (nodes_[n].low == low && nodes_[n].high == high) return;
  }
}

AabbTree::Box AabbTree::box_of(const Node& node, int depth) const {
  Box box;
  for (int k = 0; k < 3; ++k) {
    box.min[k] = origin_[k] + double{node.low[k]} / scale_;
    box.max[k] = origin_[k] + double{node.high[k]} / scale_;
  }
  box.depth = depth;
  box.leaf = node.leaf();
  box.hit = node.hit;
  return box;
}

AabbTree::Box AabbTree::bounds() const { return root_ == kNone ? Box{} : box_of(nodes_[root_], 0); }

void AabbTree::for_each_box(const std::function<void(const Box&)>& visit) const {
  if (root_ == kNone) return;
  std::vector<std::pair<uint32_t, int>> stack{{root_, 0}};
  while (!stack.empty()) {
    const auto [n, depth] = stack.back();
    stack.pop_back();
    const Node& node = nodes_[n];
    visit(box_of(node, depth));
    if (node.leaf()) continue;
    stack.emplace_back(node.child[1], depth + 1);
    stack.emplace_back(node.child[0], depth + 1);
  }
}

// Queries ------------------------------------------------------------------------------------------------

namespace {

// A slab against boxes of a tree's scaled frame: three axes, each with the interval it must meet.
struct ScaledSlab {
  std::array<Vec3, 3> axes;
  std::array<Vec3, 3> sizes;  // absolute values of the axes
  std::array<Interval, 3> intervals;

  bool meets(const Vec3& centre, const Vec3& half) const {
    for (int i = 0; i < 3; ++i) {
      const double c = glm::dot(axes[i], centre), h = glm::dot(sizes[i], half);
      if (c - h > intervals[i].high || c + h < intervals[i].low) return false;
    }
    return true;
  }
};

ScaledSlab scale_slab(const SweptCylinder::Slab& slab, const Vec3& origin, double scale) {
  ScaledSlab s{{slab.axis, slab.along, slab.across}, {}, {slab.depth, slab.motion, slab.lateral}};
  const Vec3 from = (slab.origin - origin) * scale;
  for (int i = 0; i < 3; ++i) {
    s.sizes[i] = glm::abs(s.axes[i]);
    const double base = glm::dot(s.axes[i], from);
    Interval& v = s.intervals[i];
    v = {base + v.low * scale, base + v.high * scale};
    // Boxes lie within [-2, 2]; the larger numbers are those of the beam.
    const double slack = kBoxSlack * (8 + std::abs(from.x) + std::abs(from.y) + std::abs(from.z) +
                                      std::abs(v.low) + std::abs(v.high));
    v = {v.low - slack, v.high + slack};
  }
  return s;
}

Vec3 centre_of(const std::array<float, 3>& low, const std::array<float, 3>& high) {
  return {0.5 * (double{low[0]} + high[0]), 0.5 * (double{low[1]} + high[1]),
          0.5 * (double{low[2]} + high[2])};
}
Vec3 half_of(const std::array<float, 3>& low, const std::array<float, 3>& high) {
  return {0.5 * (double{high[0]} - low[0]), 0.5 * (double{high[1]} - low[1]),
          0.5 * (double{high[2]} - low[2])};
}

}  // namespace

QueryCounts AabbTree::touched(const Mesh& mesh, const SweptCylinder& beam, std::vector<FaceId>& out) {
  QueryCounts counts;
  if (root_ == kNone) return counts;
  // The depths at which the tree has anything, so that the far end of a tilting beam does not widen the slab.
  const Box all = bounds();
  const SweptCylinder::Slab open =
      beam.slab({std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()});
  const Vec3 centre = 0.5 * all.min + 0.5 * all.max - open.origin, half = 0.5 * (all.max - all.min);
  const double depth = glm::dot(open.axis, centre),
               reach = (1 + kBoxSlack) * glm::dot(glm::abs(open.axis), half);
  const ScaledSlab slab = scale_slab(beam.slab({depth - reach, depth + reach}), origin_, scale_);

  std::vector<uint32_t> stack{root_};
  while (!stack.empty()) {
    Node& node = nodes_[stack.back()];
    stack.pop_back();
    ++counts.boxes;
    if (!slab.meets(centre_of(node.low, node.high), half_of(node.low, node.high))) continue;
    node.hit = true;
    if (!node.leaf()) {
      stack.push_back(node.child[1]);
      stack.push_back(node.child[0]);
      continue;
    }
    ++counts.faces;
    if (beam.touches(mesh.triangle(FaceId(node.child[0])))) out.emplace_back(node.child[0]);
  }
  return counts;
}

}  // namespace kerf
