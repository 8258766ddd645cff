#pragma once

#include "core/base/tolerances.h"
#include "core/tree/walks.h"

namespace kerf {

// The tree traversals over vectors of eight and of four floats. All functions are members of this template,
// so that each instruction set gets its own instantiation.
template <typename Float8, typename Float4>
class WalkCode {
 public:
  static constexpr Walks walks() { return {ray, rays, nearest, slab}; }

 private:
  // Lists --------------------------------------------------------------------------------------------------

  static void push(WalkLists& lists, WordList& list, uintptr_t word) {
    if (list.count == list.capacity) lists.grow(lists, list);
    list.items[list.count++] = word;
  }

  // Reserves capacity for `more` words. Loops reserve their maximum in advance, so that they call no
  // functions and keep their variables in registers.
  static void make_room(WalkLists& lists, WordList& list, uint32_t more) {
    while (list.count + more > list.capacity) lists.grow(lists, list);
  }
  static bool has_room(const WordList& list, uint32_t count, uint32_t more) {
    return count + more <= list.capacity;
  }

  static const WideNode* node_at(const TreeView& tree, uint32_t index) {
    return tree.nodes[index >> TreeView::kShift] + (index & ((1u << TreeView::kShift) - 1));
  }
  static const FaceBlock* block_at(const TreeView& tree, uint32_t index) {
    return tree.blocks[index >> TreeView::kShift] + (index & ((1u << TreeView::kShift) - 1));
  }

  template <int kLines>
  static void prefetch(const void* record) {
    for (int line = 0; line < kLines; ++line)
      __builtin_prefetch(static_cast<const char*>(record) + 64 * line);
  }

  static const WideNode* take_node(const TreeView& tree, uint32_t bits) {
    const WideNode* node = node_at(tree, bits);
    prefetch<4>(node);
    return node;
  }
  static const FaceBlock* take_block(const TreeView& tree, uint32_t bits) {
    const FaceBlock* block = block_at(tree, bits & ~Child::kBlockBit);
    prefetch<4>(block);
    return block;
  }

  // Lists the children of a node whose bits are set in the mask.
  static void list_children(const TreeView& tree, const WideNode& node, unsigned mask, WalkLists& lists) {
    for (; mask != 0; mask &= mask - 1) {
      const uint32_t bits = node.child[__builtin_ctz(mask)].bits;
      if ((bits & Child::kBlockBit) != 0) {
        push(lists, lists.blocks, reinterpret_cast<uintptr_t>(take_block(tree, bits)));
      } else {
        push(lists, lists.nodes, reinterpret_cast<uintptr_t>(take_node(tree, bits)));
      }
    }
  }

  static void prefetch_position(const RayQuery& q, uint32_t vertex) {
    constexpr uint32_t kMask = (uint32_t{1} << RayQuery::kPositionShift) - 1;
    __builtin_prefetch(q.positions[vertex >> RayQuery::kPositionShift] + 24 * size_t{vertex & kMask});
  }

  // Precondition: the list has room for one more word.
  static void list_face(const RayQuery& q, const FaceBlock& block, unsigned lane, unsigned ray,
                        WordList& faces) {
    for (int i = 0; i < 3; ++i) prefetch_position(q, block.vertex[i][lane]);
    faces.items[faces.count++] = face_word(&block, lane, ray);
  }

  static unsigned filled(const FaceBlock& block) { return (1u << block.count) - 1; }

  // Rays against boxes -------------------------------------------------------------------------------------

  struct RaySlabs {
    explicit RaySlabs(const RayQuery& q) : low(Float8::all(q.t_low)), high(Float8::all(q.t_high)) {
      for (int k = 0; k < 3; ++k) {
        near_plane[k] = q.near_plane[k];
        far_plane[k] = q.far_plane[k];
        near_slope[k] = Float8::all(q.near_slope[k]);
        far_slope[k] = Float8::all(q.far_slope[k]);
        near_offset[k] = Float8::all(q.near_offset[k]);
        far_offset[k] = Float8::all(q.far_offset[k]);
      }
    }
    Float8 entry(const WideNode& n, int k) const {
      return product_minus(Float8::load(n.plane[near_plane[k]]), near_slope[k], near_offset[k]);
    }
    Float8 exit(const WideNode& n, int k) const {
      return product_minus(Float8::load(n.plane[far_plane[k]]), far_slope[k], far_offset[k]);
    }
    Float8 entry(const WideNode& n) const {
      return max(max(entry(n, 0), entry(n, 1)), max(entry(n, 2), low));
    }
    Float8 exit(const WideNode& n) const { return min(min(exit(n, 0), exit(n, 1)), min(exit(n, 2), high)); }

    uint32_t near_plane[3], far_plane[3];
    Float8 near_slope[3], far_slope[3], near_offset[3], far_offset[3];
    Float8 low, high;
  };

  // Rays against triangles ---------------------------------------------------------------------------------

  // The shear that makes the rays parallel to the axis of their largest component: that axis, the two others,
  // the shear's factors, and the sheared position of each ray.
  struct Shear {
    Shear() = default;
    explicit Shear(const RayQuery& q) {
      const float* d = q.direction;
      along = longest_axis(__builtin_fabsf(d[0]), __builtin_fabsf(d[1]), __builtin_fabsf(d[2]));
      across[0] = kNextAxis[along];
      across[1] = kNextAxis[across[0]];
      for (int k = 0; k < 2; ++k) {
        slope[k] = d[across[k]] / d[along];
        for (uint32_t i = 0; i < q.rays; ++i)
          pass[i][k] = q.passing[i][across[k]] - slope[k] * q.passing[i][along];
      }
    }
    int along, across[2];
    float slope[2];
    float pass[kBlockWidth][2];
  };

  // The sheared corners of a block's faces and the error bound of their edge functions.
  struct ShearedBlock {
    ShearedBlock(const FaceBlock& b, const Shear& shear, const RayQuery& q) {
      const Float4 shear_x = Float4::all(shear.slope[0]), shear_y = Float4::all(shear.slope[1]);
      for (int i = 0; i < 3; ++i) {
        const Float4 z = Float4::load(b.corner[i][shear.along]);
        x[i] = minus_product(Float4::load(b.corner[i][shear.across[0]]), shear_x, z);
        y[i] = minus_product(Float4::load(b.corner[i][shear.across[1]]), shear_y, z);
      }
      // The bound matters only if the ray hits the triangle; the extent of the triangle then bounds all
      // coordinates relative to the ray.
      const Float4 wide = max(max(x[0], x[1]), x[2]) - min(min(x[0], x[1]), x[2]);
      const Float4 tall = max(max(y[0], y[1]), y[2]) - min(min(y[0], y[1]), y[2]);
      const Float4 extent = max(wide, tall) + Float4::all(2 * q.error);
      error = extent * (extent * Float4::all(kEdgeRoundings) + Float4::all(8 * q.error));
    }

    // Masks of the faces that the ray may cross, and of those that it certainly crosses.
    struct Lanes {
      unsigned may, sure;
    };
    Lanes hold(const float (&pass)[2]) const {
      const Float4 px = Float4::all(pass[0]), py = Float4::all(pass[1]);
      const Float4 ax = x[0] - px, ay = y[0] - py, bx = x[1] - px, by = y[1] - py, cx = x[2] - px,
                   cy = y[2] - py;
      const Float4 u = product_minus(ax, by, ay * bx), v = product_minus(bx, cy, by * cx),
                   w = product_minus(cx, ay, cy * ax);
      const Float4 least = min(min(u, v), w), most = max(max(u, v), w), under = Float4::all(0) - error;
      return {le(under, least) | le(most, error), le(error, least) | le(most, under)};
    }

    Float4 x[3], y[3], error;
  };

  // The walks ----------------------------------------------------------------------------------------------

  // Visits nodes breadth-first, which leaves prefetches time to complete.
  static void list_blocks_on_rays(const TreeView& tree, const RayQuery& q, WalkLists& lists) {
    push(lists, lists.nodes, reinterpret_cast<uintptr_t>(node_at(tree, tree.root)));
    for (uint32_t next = 0; next < lists.nodes.count;) {
      make_room(lists, lists.nodes, kNodeWidth);
      make_room(lists, lists.blocks, kNodeWidth);
      next = open_listed(tree, q, lists, next);
    }
  }

  // Opens the listed nodes from index `next` on while the lists have capacity. Returns the index of the first
  // unopened node.
  static uint32_t open_listed(const TreeView& tree, const RayQuery& q, WalkLists& lists, uint32_t next) {
    const RaySlabs slabs(q);
    uintptr_t *const nodes = lists.nodes.items, *const blocks = lists.blocks.items;
    uint32_t node_count = lists.nodes.count, block_count = lists.blocks.count;
    for (; next < node_count && has_room(lists.nodes, node_count, kNodeWidth) &&
           has_room(lists.blocks, block_count, kNodeWidth);
         ++next) {
      const auto& node = *reinterpret_cast<const WideNode*>(nodes[next]);
      for (unsigned mask = le(slabs.entry(node), slabs.exit(node)); mask != 0; mask &= mask - 1) {
        const uint32_t bits = node.child[__builtin_ctz(mask)].bits;
        if ((bits & Child::kBlockBit) != 0) {
          blocks[block_count++] = reinterpret_cast<uintptr_t>(take_block(tree, bits));
        } else {
          nodes[node_count++] = reinterpret_cast<uintptr_t>(take_node(tree, bits));
        }
      }
    }
    lists.nodes.count = node_count;
    lists.blocks.count = block_count;
    return next;
  }

  static void ray(const TreeView& tree, const RayQuery& q, WalkLists& lists) {
    list_blocks_on_rays(tree, q, lists);
    if (lists.blocks.count == 0) return;
    const Shear shear(q);
    make_room(lists, lists.faces, kBlockWidth * lists.blocks.count);
    for (uint32_t i = 0; i < lists.blocks.count; ++i) {
      const auto* block = reinterpret_cast<const FaceBlock*>(lists.blocks.items[i]);
      unsigned lanes = ShearedBlock(*block, shear, q).hold(shear.pass[0]).may & filled(*block);
      for (; lanes != 0; lanes &= lanes - 1) {
        list_face(q, *block, static_cast<unsigned>(__builtin_ctz(lanes)), 0, lists.faces);
      }
    }
  }

  // The sheared corners of a block, duplicated to test two rays at a time.
  struct ShearedTwice {
    explicit ShearedTwice(const ShearedBlock& b) : error(Float8::twice(b.error)) {
      for (int i = 0; i < 3; ++i) {
        x[i] = Float8::twice(b.x[i]);
        y[i] = Float8::twice(b.y[i]);
      }
    }
    // Bits 0 to 3: the faces that the first ray may cross; bits 4 to 7: those of the second.
    unsigned may_hold(Float8 px, Float8 py) const {
      const Float8 ax = x[0] - px, ay = y[0] - py, bx = x[1] - px, by = y[1] - py, cx = x[2] - px,
                   cy = y[2] - py;
      const Float8 u = product_minus(ax, by, ay * bx), v = product_minus(bx, cy, by * cx),
                   w = product_minus(cx, ay, cy * ax);
      const Float8 least = min(min(u, v), w), most = max(max(u, v), w), under = Float8::all(0) - error;
      return le(under, least) | le(most, error);
    }

    Float8 x[3], y[3], error;
  };

  // Copies of the first ray replace missing rays; their results are masked out.
  static void rays(const TreeView& tree, const RayQuery& q, WalkLists& lists) {
    list_blocks_on_rays(tree, q, lists);
    if (lists.blocks.count == 0) return;
    const Shear shear(q);
    Float8 px[2], py[2];
    for (uint32_t pair = 0; pair < 2; ++pair) {
      const uint32_t a = 2 * pair < q.rays ? 2 * pair : 0, b = 2 * pair + 1 < q.rays ? 2 * pair + 1 : 0;
      px[pair] = Float8::pair(shear.pass[a][0], shear.pass[b][0]);
      py[pair] = Float8::pair(shear.pass[a][1], shear.pass[b][1]);
    }
    const unsigned wanted = (1u << 4 * q.rays) - 1;
    for (uint32_t i = 0; i < lists.blocks.count; ++i) {
      make_room(lists, lists.faces, kBlockWidth * q.rays);
      const auto* block = reinterpret_cast<const FaceBlock*>(lists.blocks.items[i]);
      const ShearedTwice twice(ShearedBlock(*block, shear, q));
      unsigned found = twice.may_hold(px[0], py[0]) | twice.may_hold(px[1], py[1]) << 8;
      for (found &= wanted & filled(*block) * 0x1111u; found != 0; found &= found - 1) {
        const auto bit = static_cast<unsigned>(__builtin_ctz(found));
        list_face(q, *block, bit & 3, bit >> 2, lists.faces);
      }
    }
  }

  // Visits the nearest child of a node next and pushes the others on a stack as pairs of words: the bits of
  // the float t at which the ray enters the box, which for positive floats compare like the floats, and the
  // address of the record, plus one for a block.
  static void nearest(const TreeView& tree, const RayQuery& q, WalkLists& lists) {
    float t_high = q.t_high;
    Shear shear;
    bool sheared = false;
    uintptr_t next = reinterpret_cast<uintptr_t>(node_at(tree, tree.root));
    while ((next = nearest_block(tree, q, t_high, lists.nodes, next)) != 0) {
      if (!is_block(next)) {
        make_room(lists, lists.nodes, kStackedANode);
        continue;
      }
      if (!sheared) {
        shear = Shear(q);
        sheared = true;
      }
      make_room(lists, lists.faces, kBlockWidth);
      t_high = list_near_faces(*reinterpret_cast<const FaceBlock*>(next - 1), shear, q, t_high, lists.faces);
      next = 0;
    }
  }

  struct NearStack {
    uintptr_t* items;
    uint32_t count;
  };
  static constexpr uint32_t kStackedANode = 2 * kNodeWidth;
  static bool is_block(uintptr_t word) { return (word & 1) != 0; }

  // Advances from the record `next`, or from the top of the stack if `next` is 0, to the next block and
  // returns it. Returns a node if the stack lacks the capacity to open it, and 0 if no record is left up to
  // t_high.
  static uintptr_t nearest_block(const TreeView& tree, const RayQuery& q, float t_high, WordList& list,
                                 uintptr_t next) {
    RaySlabs slabs(q);
    slabs.high = Float8::all(t_high);
    NearStack stack{list.items, list.count};
    for (;;) {
      while (next == 0 && stack.count > 0) {
        stack.count -= 2;
        const float entry = __builtin_bit_cast(float, static_cast<uint32_t>(stack.items[stack.count]));
        if (entry <= t_high) next = stack.items[stack.count + 1];
      }
      if (next == 0 || is_block(next) || !has_room(list, stack.count, kStackedANode)) break;
      next = open_near_first(tree, *reinterpret_cast<const WideNode*>(next), slabs, stack);
    }
    list.count = stack.count;
    return next;
  }

  // Lists the faces of a block that the ray may cross up to t_high. Returns the smallest t by which the ray
  // has certainly crossed one of them, at most t_high.
  static float list_near_faces(const FaceBlock& b, const Shear& shear, const RayQuery& q, float t_high,
                               WordList& faces) {
    const auto lanes = ShearedBlock(b, shear, q).hold(shear.pass[0]);
    unsigned may = lanes.may & filled(b);
    if (may == 0) return t_high;
    const auto k = static_cast<uint32_t>(shear.along);
    const Float4 z0 = Float4::load(b.corner[0][k]), z1 = Float4::load(b.corner[1][k]),
                 z2 = Float4::load(b.corner[2][k]);
    const bool up = q.near_plane[k] == k;
    const Float4 low = min(min(z0, z1), z2), high = max(max(z0, z1), z2);
    const Float4 near_slope = Float4::all(q.near_slope[k]), far_slope = Float4::all(q.far_slope[k]);
    const Float4 from = product_minus(up ? low : high, near_slope, Float4::all(q.near_offset[k]));
    const Float4 to = product_minus(up ? high : low, far_slope, Float4::all(q.far_offset[k]));
    may &= le(from, Float4::all(t_high));
    const unsigned sure = lanes.sure & may & le(Float4::all(q.t_sure), from);
    alignas(16) float ends[kBlockWidth];
    to.store(ends);
    for (unsigned rest = sure; rest != 0; rest &= rest - 1) {
      const float end = ends[__builtin_ctz(rest)];
      t_high = end < t_high ? end : t_high;
    }
    for (; may != 0; may &= may - 1) list_face(q, b, static_cast<unsigned>(__builtin_ctz(may)), 0, faces);
    return t_high;
  }

  static uintptr_t take_child(const TreeView& tree, const WideNode& node, int slot) {
    const uint32_t bits = node.child[slot].bits;
    return (bits & Child::kBlockBit) != 0 ? reinterpret_cast<uintptr_t>(take_block(tree, bits)) + 1
                                          : reinterpret_cast<uintptr_t>(take_node(tree, bits));
  }

  // Returns the nearest child that the ray meets, or 0, and pushes the others, nearest last.
  static uintptr_t open_near_first(const TreeView& tree, const WideNode& node, const RaySlabs& slabs,
                                   NearStack& stack) {
    const Float8 entry = slabs.entry(node);
    unsigned mask = le(entry, slabs.exit(node));
    if (mask == 0) return 0;
    int s = __builtin_ctz(mask);
    uintptr_t nearest = take_child(tree, node, s);
    mask &= mask - 1;
    if (mask == 0) return nearest;
    alignas(32) float entries[kNodeWidth];
    entry.store(entries);
    uint32_t nearest_key = __builtin_bit_cast(uint32_t, entries[s]);
    const uint32_t first = stack.count;
    for (; mask != 0; mask &= mask - 1) {
      s = __builtin_ctz(mask);
      uintptr_t word = take_child(tree, node, s);
      uint32_t key = __builtin_bit_cast(uint32_t, entries[s]);
      const bool swap = key < nearest_key;
      const uintptr_t near_word = swap ? word : nearest;
      const uint32_t near_key = swap ? key : nearest_key;
      word = swap ? nearest : word;
      key = swap ? nearest_key : key;
      nearest = near_word;
      nearest_key = near_key;
      sink(stack, first, key, word);
    }
    return nearest;
  }

  // Inserts a pair into the part of the stack from `first` on, which is sorted farthest first.
  static void sink(NearStack& stack, uint32_t first, uintptr_t key, uintptr_t word) {
    uint32_t at = stack.count;
    for (; at > first && stack.items[at - 2] < key; at -= 2) {
      stack.items[at] = stack.items[at - 2];
      stack.items[at + 1] = stack.items[at - 1];
    }
    stack.items[at] = key;
    stack.items[at + 1] = word;
    stack.count += 2;
  }

  // Slabs of any orientation -------------------------------------------------------------------------------

  // Returns a mask of the boxes that meet the interval of an axis.
  template <typename Float>
  static unsigned meets_axis(const SlabQuery::Axis& a, const float* planes, uint32_t stride) {
    const auto sum = [&](const uint32_t(&plane)[3]) {
      return Float::all(a.direction[0]) * Float::load(planes + plane[0] * stride) +
             Float::all(a.direction[1]) * Float::load(planes + plane[1] * stride) +
             Float::all(a.direction[2]) * Float::load(planes + plane[2] * stride);
    };
    return le(sum(a.low_plane), Float::all(a.high)) & le(Float::all(a.low), sum(a.high_plane));
  }
  template <typename Float>
  static unsigned meets(const SlabQuery& q, const float* planes, uint32_t stride) {
    return meets_axis<Float>(q.axis[1], planes, stride) & meets_axis<Float>(q.axis[2], planes, stride) &
           meets_axis<Float>(q.axis[0], planes, stride);
  }

  static unsigned boxes_that_meet(const SlabQuery& q, const FaceBlock& b) {
    alignas(16) float planes[6][kBlockWidth];
    for (int k = 0; k < 3; ++k) {
      const Float4 x = Float4::load(b.corner[0][k]), y = Float4::load(b.corner[1][k]),
                   z = Float4::load(b.corner[2][k]);
      min(min(x, y), z).store(planes[k]);
      max(max(x, y), z).store(planes[k + 3]);
    }
    return meets<Float4>(q, planes[0], kBlockWidth);
  }

  static unsigned triangles_that_meet(const SlabQuery& q, const FaceBlock& b) {
    unsigned lanes = filled(b);
    for (const SlabQuery::Axis& a : q.axis) {
      Float4 p[3];
      for (int i = 0; i < 3; ++i) {
        p[i] = Float4::all(a.direction[0]) * Float4::load(b.corner[i][0]) +
               Float4::all(a.direction[1]) * Float4::load(b.corner[i][1]) +
               Float4::all(a.direction[2]) * Float4::load(b.corner[i][2]);
      }
      lanes &= le(min(min(p[0], p[1]), p[2]), Float4::all(a.high)) &
               le(Float4::all(a.low), max(max(p[0], p[1]), p[2]));
    }
    return lanes;
  }

  static void push_lanes(WalkLists& lists, WordList& list, const FaceBlock& block, unsigned lanes) {
    for (; lanes != 0; lanes &= lanes - 1)
      push(lists, list, face_word(&block, static_cast<unsigned>(__builtin_ctz(lanes))));
  }

  static uint64_t slab(const TreeView& tree, const SlabQuery& q, WalkLists& lists) {
    push(lists, lists.nodes, reinterpret_cast<uintptr_t>(node_at(tree, tree.root)));
    uint64_t boxes = 0;
    for (uint32_t next = 0; next < lists.nodes.count; ++next) {
      const auto& node = *reinterpret_cast<const WideNode*>(lists.nodes.items[next]);
      const unsigned mask = meets<Float8>(q, node.plane[0], kNodeWidth);
      boxes += kNodeWidth;
      list_children(tree, node, mask, lists);
    }
    for (uint32_t i = 0; i < lists.blocks.count; ++i) {
      const auto& block = *reinterpret_cast<const FaceBlock*>(lists.blocks.items[i]);
      const unsigned lanes = boxes_that_meet(q, block) & filled(block);
      boxes += block.count;
      if (lanes == 0) continue;
      push_lanes(lists, lists.boxes, block, lanes);
      push_lanes(lists, lists.faces, block, lanes & triangles_that_meet(q, block));
    }
    return boxes;
  }
};

}  // namespace kerf
