#include "core/tree/touched_walk.h"

#include <algorithm>

#include "core/tree/beam_slab.h"

namespace kerf {

namespace {

using Side = TouchedWalk::Side;
using Outcome = TouchedWalk::Outcome;

// The order in which the query tests the axes of its slab.
constexpr std::array<std::pair<int, Side>, 3> kOrder{
    {{1, Side::kMotion}, {2, Side::kLateral}, {0, Side::kDepth}}};

float projection(const SlabQuery::Axis& a, const std::array<float, 3>& p) {
  return a.direction[0] * p[0] + a.direction[1] * p[1] + a.direction[2] * p[2];
}

// The interval that the box misses, planes in the order low x, y, z, high x, y, z.
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

// As the query has them, i.e. without rounding outward.
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

// Nodes are traversed breadth first and blocks after them, in the order of the query.
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
