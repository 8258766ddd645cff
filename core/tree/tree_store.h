#pragma once

#include <smmintrin.h>
#include <limits>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/records.h"
#include "core/base/tolerances.h"
#include "core/mesh/face_batches.h"
#include "core/tree/walks.h"

namespace kerf {

// An axis-aligned box in the frame of a tree, empty by default. The fourth lanes are unused.
struct FloatBox {
  __m128 low = _mm_set1_ps(std::numeric_limits<float>::infinity());
  __m128 high = _mm_set1_ps(-std::numeric_limits<float>::infinity());

  // Enlarges the box to hold another one.
  void add(__m128 l, __m128 h) {
    low = _mm_min_ps(low, l);
    high = _mm_max_ps(high, h);
  }
  void add(const FloatBox& other) { add(other.low, other.high); }
  // Returns true if the other box lies within this one.
  bool holds(const FloatBox& other) const {
    const __m128 within = _mm_and_ps(_mm_cmple_ps(low, other.low), _mm_cmpge_ps(high, other.high));
    return (_mm_movemask_ps(within) & 7) == 7;
  }
  // Half of the surface area.
  float area() const {
    const __m128 size = _mm_sub_ps(high, low);
    const __m128 turned = _mm_shuffle_ps(size, size, _MM_SHUFFLE(3, 0, 2, 1));
    return _mm_cvtss_f32(_mm_dp_ps(size, turned, 0x71));
  }
  friend bool operator==(const FloatBox& a, const FloatBox& b) {
    const __m128 equal = _mm_and_ps(_mm_cmpeq_ps(a.low, b.low), _mm_cmpeq_ps(a.high, b.high));
    return (_mm_movemask_ps(equal) & 7) == 7;
  }
};

// Returns bounds in float for the doubles that these floats were rounded from; see kFloatSlack.
inline __m128 float_slack(__m128 x) {
  const __m128 size = _mm_andnot_ps(_mm_set1_ps(-0.0f), x);
  return _mm_add_ps(_mm_mul_ps(size, _mm_set1_ps(kFloatSlack)), _mm_set1_ps(kFloatLeast));
}
inline __m128 round_down(__m128 x) { return _mm_sub_ps(x, float_slack(x)); }
inline __m128 round_up(__m128 x) { return _mm_add_ps(x, float_slack(x)); }

// Return the minimum and the maximum of each of three rows of four floats, in lanes 0 to 2.
inline __m128 min_of_rows(__m128 x, __m128 y, __m128 z) {
  __m128 w = z;
  _MM_TRANSPOSE4_PS(x, y, z, w);
  return _mm_min_ps(_mm_min_ps(x, y), _mm_min_ps(z, w));
}
inline __m128 max_of_rows(__m128 x, __m128 y, __m128 z) {
  __m128 w = z;
  _MM_TRANSPOSE4_PS(x, y, z, w);
  return _mm_max_ps(_mm_max_ps(x, y), _mm_max_ps(z, w));
}

// The frame of a tree: its boxes have the coordinates (x - origin) * scale, so that any mesh lies within
// about [-1, 1] and the precision of floats suffices for culling.
struct TreeFrame {
  Vec3 origin{0};
  double scale = 1;  // a power of two

  // Returns the frame for faces with these bounds, the identity if they are empty.
  static TreeFrame around(const Bounds& bounds);

  Vec3 to_tree(const Vec3& p) const { return (p - origin) * scale; }
  // Returns the point in the frame of the tree, rounded to the nearest floats; the fourth lane is zero.
  __m128 to_floats(const Vec3& point) const {
    const double* p = &point.x;
    const __m128d factor = _mm_set1_pd(scale);
    const __m128d xy = _mm_mul_pd(_mm_sub_pd(_mm_loadu_pd(p), _mm_loadu_pd(&origin.x)), factor);
    const __m128d z = _mm_mul_sd(_mm_sub_sd(_mm_load_sd(p + 2), _mm_load_sd(&origin.z)), factor);
    return _mm_movelh_ps(_mm_cvtpd_ps(xy), _mm_cvtpd_ps(_mm_move_sd(_mm_setzero_pd(), z)));
  }
  Vec3 to_mesh(const Vec3& p) const { return origin + p / scale; }
};

// A face as the tree stores it: its vertices and their positions as floats in the frame of the tree.
struct TreeFace {
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
    return {round_down(_mm_min_ps(_mm_min_ps(corner[0], corner[1]), corner[2])),
            round_up(_mm_max_ps(_mm_max_ps(corner[0], corner[1]), corner[2]))};
  }

  __m128 corner[3];
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
