#include "core/tree/touched_walk.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "core/base/tolerances.h"
#include "core/tree/aabb_tree.h"
#include "core/tree/tree_internal.h"

namespace kerf {

namespace {

// Returns an axis interval of the beam's slab in the frame of the tree, widened by all rounding errors.
SlabQuery::Axis tree_axis(const TreeStore& tree, double reach, const Vec3& axis, const Vec3& slab_origin,
                          Interval interval) {
  SlabQuery::Axis a;
  for (uint32_t k = 0; k < 3; ++k) {
    a.direction[k] = static_cast<float>(axis[static_cast<int>(k)]);
    a.low_plane[k] = a.direction[k] >= 0 ? k : k + 3;
    a.high_plane[k] = a.direction[k] >= 0 ? k + 3 : k;
  }
  const double scale = tree.frame.scale;
  const Vec3 from = (slab_origin - tree.frame.origin) * scale;
  const double base = glm::dot(axis, from), low = interval.low * scale, high = interval.high * scale;
  const double slack =
      reach * kProjectionRoundings + kBoxSlack * (8 * reach + std::abs(from.x) + std::abs(from.y) +
                                                  std::abs(from.z) + std::abs(low) + std::abs(high));
  const double most = 8 * reach;
  a.low = static_cast<float>(std::clamp(base + low - slack, -most, most));
  a.high = static_cast<float>(std::clamp(base + high + slack, -most, most));
  return a;
}

Vec3 corner(const TreeStore& tree, __m128 p) {
  alignas(16) float xyz[4];
  _mm_store_ps(xyz, p);
  return tree.frame.to_mesh(Vec3(xyz[0], xyz[1], xyz[2]));
}

}  // namespace

// Clamps depths to the tree, so that the far end of a tilting beam does not widen the slab.
SlabQuery beam_slab(const TreeStore& tree, const SweptCylinder& beam) {
  assert(tree.root != kNoIndex);
  const Vec3 low = corner(tree, tree.root_box().low), high = corner(tree, tree.root_box().high);
  const SweptCylinder::Slab open =
      beam.slab({std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()});
  const Vec3 centre = 0.5 * low + 0.5 * high - open.origin, half = 0.5 * (high - low);
  const double depth = glm::dot(open.axis, centre),
               deep = (1 + kBoxSlack) * glm::dot(glm::abs(open.axis), half);
  const SweptCylinder::Slab slab = beam.slab({depth - deep, depth + deep});
  const double reach = tree.reach();
  return {{tree_axis(tree, reach, slab.axis, slab.origin, slab.depth),
           tree_axis(tree, reach, slab.along, slab.origin, slab.motion),
           tree_axis(tree, reach, slab.across, slab.origin, slab.lateral)}};
}

QueryCounts AabbTree::touched(const Mesh& mesh, const SweptCylinder& beam, std::vector<FaceId>& out,
                              std::vector<FaceId>* near) const {
  QueryCounts counts;
  if (store_.root == kNoIndex) return counts;
  const SlabQuery query = beam_slab(store_, beam);
  WalkScratch scratch;
  counts.boxes = walks_->slab(store_.view(), query, scratch);
  counts.faces = scratch.found().size();
  const auto face = [](uintptr_t word) { return FaceId(block_of(word)->face[lane_of(word)]); };
  if (near) {
    for (const uintptr_t word : scratch.met()) near->push_back(face(word));
  }
  const size_t first = out.size();
  for (const uintptr_t word : scratch.found()) {
    if (beam.touches(mesh.triangle(face(word)))) out.push_back(face(word));
  }
  Shuffle::selected().reorder(out, first);
  return counts;
}

namespace {

using Side = TouchedWalk::Side;
using Outcome = TouchedWalk::Outcome;

constexpr std::array<std::pair<int, Side>, 3> kOrder{
    {{1, Side::kMotion}, {2, Side::kLateral}, {0, Side::kDepth}}};

float projection(const SlabQuery::Axis& a, const std::array<float, 3>& p) {
  return a.direction[0] * p[0] + a.direction[1] * p[1] + a.direction[2] * p[2];
}

// Returns the interval that the box misses; planes in the order low x, y, z, high x, y, z.
Side missed_by(const SlabQuery& q, const std::array<float, 6>& plane) {
  for (const auto& [index, side] : kOrder) {
    const SlabQuery::Axis& a = q.axis[index];
    const auto sum = [&](const uint32_t(&at)[3]) {
      return projection(a, {plane[at[0]], plane[at[1]], plane[at[2]]});
    };
    if (!(sum(a.low_plane) <= a.high && a.low <= sum(a.high_plane))) return side;
  }
  return Side::kNone;
}

Side missed_by(const SlabQuery& q, const FaceBlock& block, uint32_t lane) {
  for (const auto& [index, side] : kOrder) {
    const SlabQuery::Axis& a = q.axis[index];
    std::array<float, 3> p{};
    for (size_t i = 0; i < 3; ++i)
      p[i] = projection(a, {block.corner[i][0][lane], block.corner[i][1][lane], block.corner[i][2][lane]});
    const auto [low, high] = std::minmax_element(p.begin(), p.end());
    if (!(*low <= a.high && a.low <= *high)) return side;
  }
  return Side::kNone;
}

std::array<float, 6> planes_of(const WideNode& node, uint32_t slot) {
  std::array<float, 6> planes{};
  for (size_t k = 0; k < 6; ++k) planes[k] = node.plane[k][slot];
  return planes;
}

// Returns the planes as in the query, i.e. without rounding outward.
std::array<float, 6> planes_of(const FaceBlock& block, uint32_t lane) {
  std::array<float, 6> planes{};
  for (size_t k = 0; k < 3; ++k) {
    const float a = block.corner[0][k][lane], b = block.corner[1][k][lane], c = block.corner[2][k][lane];
    planes[k] = std::min({a, b, c});
    planes[k + 3] = std::max({a, b, c});
  }
  return planes;
}

}  // namespace

// Traverses nodes breadth-first and blocks after them, in the order of the query.
class TouchedTrace {
 public:
  TouchedTrace(const AabbTree& tree, const Mesh& mesh, const SweptCylinder& beam)
      : tree_(tree), mesh_(mesh), beam_(beam), slab_(beam_slab(tree.store_, beam)) {}

  static std::optional<TreeSlot> slot_of(const AabbTree& tree, const Mesh& mesh, FaceId face) {
    const uint32_t place = tree.store_.place(face);
    if (place == kNoIndex) return std::nullopt;
    const uint32_t block = place / kBlockWidth, lane = place % kBlockWidth;
    return TreeSlot{block, lane, mesh.data(face).hit};
  }

  TouchedWalk run() {
    const TreeStore& store = tree_.store_;
    add(tree_.box_of(store.root_box(), 0, false, false), TouchedWalk::kNoParent, Side::kNone);
    nodes_.push_back({store.root, 0});
    for (size_t i = 0; i < nodes_.size(); ++i) open_node(nodes_[i]);
    for (const Place& block : blocks_) open_block(block);
    std::sort(walk_.touched.begin(), walk_.touched.end());
    return std::move(walk_);
  }

 private:
  struct Place {
    uint32_t record;  // node or block
    uint32_t visit;   // of its box
  };

  uint32_t add(const AabbTree::Box& box, uint32_t parent, Side outside) {
    walk_.visits.push_back(
        {box, parent, outside == Side::kNone ? Outcome::kEntered : Outcome::kCulled, outside, {}});
    return static_cast<uint32_t>(walk_.visits.size() - 1);
  }

  void open_node(Place at) {
    const TreeStore& store = tree_.store_;
    const WideNode& node = store.nodes[at.record];
    walk_.counts.boxes += kNodeWidth;
    for (uint32_t s = 0; s < kNodeWidth; ++s) {
      const Child child = node.child[s];
      if (child.none()) continue;
      const int depth = walk_.visits[at.visit].box.depth + 1;
      const Side outside = missed_by(slab_, planes_of(node, s));
      const uint32_t visit =
          add(tree_.box_of(store.slot_box(at.record, s), depth, false, false), at.visit, outside);
      if (outside != Side::kNone) continue;
      (child.is_block() ? blocks_ : nodes_).push_back({child.index(), visit});
    }
  }

  void open_block(Place at) {
    const TreeStore& store = tree_.store_;
    const FaceBlock& block = store.blocks[at.record];
    walk_.counts.boxes += block.count;
    for (uint32_t lane = 0; lane < block.count; ++lane) {
      const bool hit = mesh_.data(FaceId(block.face[lane])).hit;
      const int depth = walk_.visits[at.visit].box.depth + 1;
      Side outside = missed_by(slab_, planes_of(block, lane));
      if (outside == Side::kNone) outside = missed_by(slab_, block, lane);
      const uint32_t visit =
          add(tree_.box_of(store.face_box(block, lane), depth, true, hit), at.visit, outside);
      walk_.visits[visit].face = FaceId(block.face[lane]);
      if (outside == Side::kNone) test_face(walk_.visits[visit]);
    }
  }

  void test_face(TouchedWalk::Visit& visit) {
    ++walk_.counts.faces;
    const bool touched = beam_.touches(mesh_.triangle(visit.face));
    visit.outcome = touched ? Outcome::kTouched : Outcome::kMissed;
    if (touched) walk_.touched.push_back(visit.face);
  }

  const AabbTree& tree_;
  const Mesh& mesh_;
  const SweptCylinder& beam_;
  SlabQuery slab_;
  std::vector<Place> nodes_, blocks_;
  TouchedWalk walk_;
};

std::optional<TreeSlot> tree_slot(const AabbTree& tree, const Mesh& mesh, FaceId face) {
  return TouchedTrace::slot_of(tree, mesh, face);
}

TouchedWalk trace_touched(const AabbTree& tree, const Mesh& mesh, const SweptCylinder& beam) {
  return tree.leaf_count() == 0 ? TouchedWalk{} : TouchedTrace(tree, mesh, beam).run();
}

}  // namespace kerf
