#pragma once

#include <limits>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/records.h"
#include "core/base/tolerances.h"
#include "core/mesh/face_batches.h"
#include "core/tree/lanes.h"
#include "core/tree/walks.h"

namespace kerf {

// An axis-aligned box in the frame of a tree, empty by default. The fourth lanes are unused.
struct FloatBox {
  Float4 low = all_lanes(std::numeric_limits<float>::infinity());
  Float4 high = all_lanes(-std::numeric_limits<float>::infinity());

  // Enlarges the box to hold another one.
  void add(Float4 l, Float4 h) {
    low = min_lanes(low, l);
    high = max_lanes(high, h);
  }
  void add(const FloatBox& other) { add(other.low, other.high); }
  // Returns true if the other box lies within this one.
  bool holds(const FloatBox& other) const {
    return (mask_bits((low <= other.low) & (high >= other.high)) & 7) == 7;
  }
  // Half of the surface area.
  float area() const {
    const Float4 size = high - low;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
  friend bool operator==(const FloatBox& a, const FloatBox& b) {
    return (mask_bits((a.low == b.low) & (a.high == b.high)) & 7) == 7;
  }
};

// Returns bounds in float for the doubles that these floats were rounded from; see kFloatSlack.
inline Float4 float_slack(Float4 x) { return abs_lanes(x) * kFloatSlack + kFloatLeast; }
inline Float4 round_down(Float4 x) { return x - float_slack(x); }
inline Float4 round_up(Float4 x) { return x + float_slack(x); }

// Return the minimum and the maximum of each of three rows of four floats, in lanes 0 to 2.
inline Float4 min_of_rows(Float4 x, Float4 y, Float4 z) {
  Float4 m[]{x, y, z, z};
  transpose_lanes(m);
  return min_lanes(min_lanes(m[0], m[1]), min_lanes(m[2], m[3]));
}
inline Float4 max_of_rows(Float4 x, Float4 y, Float4 z) {
  Float4 m[]{x, y, z, z};
  transpose_lanes(m);
  return max_lanes(max_lanes(m[0], m[1]), max_lanes(m[2], m[3]));
}

// The frame of a tree: its boxes have the coordinates (x - origin) * scale, so that any mesh lies within
// [-2, 2] when the tree is built, and the precision of floats suffices for culling.
struct TreeFrame {
  Vec3 origin{0};
  double scale = 1;  // a power of two

  // Returns the frame for faces with these bounds, the identity if they are empty.
  static TreeFrame around(const Bounds& bounds);

  Vec3 to_tree(const Vec3& p) const { return (p - origin) * scale; }
  // Returns the point in the frame of the tree, rounded to the nearest floats; the fourth lane is zero.
  Float4 to_floats(const Vec3& point) const {
    const Vec3 p = to_tree(point);
    return narrow_lanes(p.x, p.y, p.z);
  }
  Vec3 to_mesh(const Vec3& p) const { return origin + p / scale; }
};

// A face as the tree stores it: its vertices and their positions as floats in the frame of the tree.
struct TreeFace {
  TreeFace() = default;
  TreeFace(const TreeFrame& frame, const Mesh& mesh, FaceId f) : TreeFace(frame, mesh, mesh.positions(), f) {}
  // For many faces: the caller passes mesh.positions() once.
  TreeFace(const TreeFrame& frame, const Mesh& mesh, Positions positions, FaceId f)
      : vertex(mesh.corners(f)), face(f) {
    for (int i = 0; i < 3; ++i) corner[i] = frame.to_floats(positions[vertex[i]]);
  }
  // Face i of a batch.
  TreeFace(const TreeFrame& frame, const TriangleBatch& batch, uint32_t i)
      : vertex(batch.corners(i)), face(batch.face(i)) {
    for (int k = 0; k < 3; ++k) corner[k] = frame.to_floats(batch.triangle(i)[k]);
  }
  // The bounding box, rounded outward.
  FloatBox box() const {
    return {round_down(min_lanes(min_lanes(corner[0], corner[1]), corner[2])),
            round_up(max_lanes(max_lanes(corner[0], corner[1]), corner[2]))};
  }

  Float4 corner[3];
  std::array<VertexId, 3> vertex;
  FaceId face;
};

// Resets a node to one without parent and children.
void make_empty(WideNode& node);

// Sets the box of a slot. Precondition: slot < kNodeWidth.
void set_slot_box(WideNode& node, uint32_t slot, const FloatBox& box);

// The state of a tree apart from its records.
struct TreeCounts {
  uint32_t root = kNoIndex;
  uint32_t free_node = kNoIndex, free_block = kNoIndex;  // heads of the free lists
  uint32_t free_node_count = 0, free_block_count = 0;
  uint32_t single_count = 0;
  FloatBox root_box;
  double reach = 0;
};

// The records of a tree and their links. Every block and every node but the root occupies a slot of its
// parent; the root, if any, is a node. Freed records are reused, the last freed first.
class TreeStore : private TreeCounts {
 public:
  TreeFrame frame;
  Records<WideNode> nodes;
  Records<FaceBlock> blocks;
  using TreeCounts::root;

  uint32_t add_node();
  uint32_t add_block();
  void free_node(uint32_t n);
  void free_block(uint32_t b);
  uint32_t node_count() const { return nodes.size() - TreeCounts::free_node_count; }
  uint32_t block_count() const { return blocks.size() - TreeCounts::free_block_count; }
  uint32_t single_count() const { return TreeCounts::single_count; }  // blocks with a single face
  void set_count(uint32_t block, uint32_t count);

  // Returns the place of a face as block * kBlockWidth + lane; kNoIndex if the face is not in the tree.
  uint32_t place(FaceId f) const { return f.index < places_.size() ? places_[f.index] - 1 : kNoIndex; }
  void set_place(FaceId f, uint32_t place);
  void prefetch_place(FaceId f) const {
    if (f.index < places_.size()) __builtin_prefetch(&places_[f.index]);
  }
  // Allocates memory for a tree over `faces` faces whose slots are below `slots`.
  void reserve(uint32_t faces, uint32_t slots);

  // Writes the face into a lane of a block. Precondition: lane < kBlockWidth.
  void put(const TreeFace& face, uint32_t block, uint32_t lane);
  // Returns true if the lane holds the face with these corners, starting from any of them.
  bool holds(const TreeFace& face, uint32_t block, uint32_t lane) const;
  FloatBox face_box(const FaceBlock& block, uint32_t lane) const;
  FloatBox block_box(const FaceBlock& block) const;
  FloatBox node_box(const WideNode& node) const;

  FloatBox slot_box(uint32_t node, uint32_t slot) const;
  void set_slot_box(uint32_t node, uint32_t slot, const FloatBox& box);
  // Stores a child with its box in a slot, and the slot in the child.
  void hang(uint32_t node, uint32_t slot, Child child, const FloatBox& box);
  void empty_slot(uint32_t node, uint32_t slot);

  const FloatBox& root_box() const { return TreeCounts::root_box; }
  void set_root_box(const FloatBox& box);
  // Radius of a sphere around the origin of the frame that contains the tree, in the frame.
  double reach() const { return TreeCounts::reach; }
  TreeView view() const {
    static_assert(decltype(nodes)::kShift == TreeView::kShift &&
                  decltype(blocks)::kShift == TreeView::kShift);
    return {nodes.chunks(), blocks.chunks(), root};
  }

  size_t bytes() const;

 private:
  Records<uint32_t> places_;  // the place plus one; 0, as in zeroed memory, if the face is absent
};

}  // namespace kerf
