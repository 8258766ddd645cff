#include "core/tree/tree_internal.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

namespace kerf {

namespace {

uint32_t block_at(uint32_t place) { return place / kBlockWidth; }
uint32_t lane_at(uint32_t place) { return place % kBlockWidth; }

template <typename Record>
void prefetch(const Record& record) {
  for (size_t at = 0; at < sizeof record; at += 64)
    __builtin_prefetch(reinterpret_cast<const char*>(&record) + at);
}

// Number of replacements by which each kind of record is prefetched ahead. A face that an earlier replacement
// has yet to create has no place and is not prefetched.
constexpr size_t kPlaceAhead = 6, kBlockAhead = 4, kNodeAhead = 2;
void prefetch_block(const TreeStore& tree, FaceId f) {
  const uint32_t place = tree.place(f);
  if (place != kNoIndex) prefetch(tree.blocks[block_at(place)]);
}
void prefetch_node(const TreeStore& tree, FaceId f) {
  const uint32_t place = tree.place(f);
  if (place != kNoIndex) prefetch(tree.nodes[tree.blocks[block_at(place)].parent]);
}

// Boxes upward ----------------------------------------------------------------------------------------------

// Enlarges the box of the node and those above it to hold `box`.
void grow_above(TreeStore& tree, uint32_t n, const FloatBox& box) {
  for (; n != tree.root; n = tree.nodes[n].parent) {
    const WideNode& node = tree.nodes[n];
    FloatBox own = tree.slot_box(node.parent, node.slot);
    if (own.holds(box)) return;
    own.add(box);
    tree.set_slot_box(node.parent, node.slot, own);
  }
  if (tree.root_box().holds(box)) return;
  FloatBox all = tree.root_box();
  all.add(box);
  tree.set_root_box(all);
}

void grow_block(TreeStore& tree, uint32_t b, const FloatBox& box) {
  const uint32_t parent = tree.blocks[b].parent, slot = tree.blocks[b].slot;
  FloatBox own = tree.slot_box(parent, slot);
  if (own.holds(box)) return;
  own.add(box);
  tree.set_slot_box(parent, slot, own);
  grow_above(tree, parent, box);
}

// Recomputes the boxes of the node and its ancestors up to the first unchanged one.
void shrink_above(TreeStore& tree, uint32_t n) {
  for (; n != tree.root; n = tree.nodes[n].parent) {
    const WideNode& node = tree.nodes[n];
    const FloatBox fitted = tree.node_box(node);
    if (fitted == tree.slot_box(node.parent, node.slot)) return;
    tree.set_slot_box(node.parent, node.slot, fitted);
  }
  tree.set_root_box(tree.node_box(tree.nodes[n]));
}

// Lanes of blocks -------------------------------------------------------------------------------------------

void copy_lane(TreeStore& tree, uint32_t from, uint32_t from_lane, uint32_t to, uint32_t to_lane) {
  const FaceBlock& a = tree.blocks[from];
  FaceBlock& b = tree.blocks.edit(to);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) b.corner[i][k][to_lane] = a.corner[i][k][from_lane];
    b.vertex[i][to_lane] = a.vertex[i][from_lane];
  }
  b.face[to_lane] = a.face[from_lane];
  tree.set_place(FaceId(b.face[to_lane]), to * kBlockWidth + to_lane);
}

// Removes a lane by moving the last one into its place.
void drop_lane(TreeStore& tree, uint32_t block, uint32_t lane) {
  assert(lane < tree.blocks[block].count);
  const uint32_t last = tree.blocks[block].count - 1u;
  tree.set_count(block, last);
  if (lane != last) copy_lane(tree, block, last, block, lane);
}

uint32_t free_slot(const WideNode& node) {
  const Int4 none = all_lanes(INT32_C(-1));
  const unsigned empty = mask_bits(load_lanes(&node.child[0].bits) == none) |
                         mask_bits(load_lanes(&node.child[4].bits) == none) << 4;
  return static_cast<uint32_t>(std::countr_zero(empty | 1u << kNodeWidth));
}

// Splitting a block -----------------------------------------------------------------------------------------

std::array<FloatBox, kBlockWidth> lane_boxes(const FaceBlock& full) {
  Float4 low[4] = {}, high[4] = {};  // by axis
  for (int k = 0; k < 3; ++k) {
    const Float4 p = load_lanes(full.corner[0][k]), q = load_lanes(full.corner[1][k]),
                 r = load_lanes(full.corner[2][k]);
    low[k] = min_lanes(min_lanes(p, q), r);
    high[k] = max_lanes(max_lanes(p, q), r);
  }
  transpose_lanes(low);
  transpose_lanes(high);
  return {{{low[0], high[0]}, {low[1], high[1]}, {low[2], high[2]}, {low[3], high[3]}}};
}

FloatBox around(FloatBox a, const FloatBox& b) {
  a.add(b);
  return a;
}

float area_of_both(const FloatBox& a, const FloatBox& b) {
  const auto sides = [](const FloatBox& box) {
    const Float4 size = box.high - box.low;
    // No product of fourth lanes, which would underflow.
    return size * __builtin_shufflevector(size, Float4{}, 1, 2, 0, 4);
  };
  const Float4 sum = sides(a) + sides(b);
  return sum[0] + sum[1] + sum[2];
}

// Finds the cheapest partition of a full block's faces and one more into two blocks.
struct Parting {
  FloatBox added;
  // The area of both boxes as the bits of a float, with the last four replaced by the mask of the lanes
  // separated from the added face: the minimum of such words is found without branches.
  uint32_t best = 0xffffffffu;

  void consider(uint32_t lanes, const FloatBox& stays, const FloatBox& goes) {
    const auto cost = std::bit_cast<uint32_t>(area_of_both(stays, around(goes, added)));
    best = std::min(best, (cost & ~15u) | lanes);
  }
  uint32_t staying() const { return best & 15; }
};

// Finds the partition of a full block's four faces and a fifth into two and three faces with the smallest
// total area, among all ten. Returns the mask of the lanes of the part without the added face.
unsigned staying_lanes(const FaceBlock& full, const FloatBox& added) {
  const auto lane = lane_boxes(full);
  Parting parting{added};
  constexpr unsigned kPairs[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}};
  for (const auto& [i, j, k, l] : kPairs) {
    const FloatBox a = around(lane[i], lane[j]), b = around(lane[k], lane[l]);
    parting.consider(1u << i | 1u << j, a, b);
    parting.consider(1u << k | 1u << l, b, a);
  }
  const FloatBox first = around(lane[0], lane[1]), last = around(lane[2], lane[3]);
  parting.consider(0b1110, around(last, lane[1]), lane[0]);
  parting.consider(0b1101, around(last, lane[0]), lane[1]);
  parting.consider(0b1011, around(first, lane[3]), lane[2]);
  parting.consider(0b0111, around(first, lane[2]), lane[3]);
  return parting.staying();
}

// Inserts a new block as a sibling of b: into a free slot of b's node or, if there is none, together with b
// into a new node that takes b's slot.
void attach_next_to(TreeStore& tree, uint32_t b, uint32_t fresh) {
  const uint32_t parent = tree.blocks[b].parent, slot = tree.blocks[b].slot;
  const FloatBox stays = tree.block_box(tree.blocks[b]), goes = tree.block_box(tree.blocks[fresh]);
  const uint32_t beside = free_slot(tree.nodes[parent]);
  if (beside < kNodeWidth) {
    tree.set_slot_box(parent, slot, stays);
    tree.hang(parent, beside, Child::block(fresh), goes);
    grow_above(tree, parent, goes);
    return;
  }
  const uint32_t n = tree.add_node();
  FloatBox both = stays;
  both.add(goes);
  tree.hang(parent, slot, Child::node(n), both);
  tree.hang(n, 0, Child::block(b), stays);
  tree.hang(n, 1, Child::block(fresh), goes);
  grow_above(tree, parent, both);
}

void rewrite_lane(TreeStore& tree, const TreeFace& face, uint32_t b, uint32_t lane) {
  tree.put(face, b, lane);
  grow_block(tree, b, face.box());
}

// Adds a face to the block; a full block is split in two.
void insert_face(TreeStore& tree, const TreeFace& face, uint32_t b) {
  const uint32_t lane = tree.blocks[b].count;
  if (lane < kBlockWidth) {
    tree.set_count(b, lane + 1);
    return rewrite_lane(tree, face, b, lane);
  }
  const uint32_t fresh = tree.add_block();
  tree.set_count(fresh, 1);
  tree.put(face, fresh, 0);
  const unsigned staying = staying_lanes(tree.blocks[b], face.box());
  for (uint32_t from = kBlockWidth; from-- > 0;) {
    if ((staying >> from & 1) != 0) continue;
    const uint32_t to = tree.blocks[fresh].count;
    tree.set_count(fresh, to + 1);
    copy_lane(tree, b, from, fresh, to);
    drop_lane(tree, b, from);
  }
  attach_next_to(tree, b, fresh);
}

// Removing records ----------------------------------------------------------------------------------------

void remove_root(TreeStore& tree) {
  tree.free_node(tree.root);
  tree.root = kNoIndex;
  tree.set_root_box(FloatBox{});
}

// Replaces a node by its only child. The root stays if the child is a block.
void hoist(TreeStore& tree, uint32_t n, uint32_t slot) {
  const Child child = tree.nodes[n].child[slot];
  assert(!child.none());
  const uint32_t parent = tree.nodes[n].parent;
  if (n != tree.root) {
    tree.hang(parent, tree.nodes[n].slot, child, tree.slot_box(n, slot));
    tree.free_node(n);
    return shrink_above(tree, parent);
  }
  if (child.is_block()) return shrink_above(tree, n);
  tree.free_node(n);
  tree.root = child.index();
  shrink_above(tree, tree.root);
}

// Removes or shrinks a node after it lost a child.
void settle(TreeStore& tree, uint32_t n) {
  const WideNode& node = tree.nodes[n];
  uint32_t children = 0, last = 0;
  for (uint32_t s = 0; s < kNodeWidth; ++s) {
    if (node.child[s].none()) continue;
    ++children;
    last = s;
  }
  if (children > 1) return shrink_above(tree, n);
  if (children == 1) return hoist(tree, n, last);
  assert(n == tree.root);
  remove_root(tree);
}

float area_of(const FloatBox& box) { return 0.5f * area_of_both(box, box); }

// Returns the block found from the root by following the slot whose box grows least with the added box.
uint32_t block_that_grows_least(const TreeStore& tree, const FloatBox& added) {
  for (uint32_t n = tree.root;;) {
    const WideNode& node = tree.nodes[n];
    Child best;
    std::pair<float, float> least;  // how much the box grows, and how large it is then
    for (uint32_t s = 0; s < kNodeWidth; ++s) {
      if (node.child[s].none()) continue;
      const FloatBox own = tree.slot_box(n, s);
      const float grown = area_of(around(own, added));
      const std::pair cost(grown - area_of(own), grown);
      if (best.none() || cost < least) {
        best = node.child[s];
        least = cost;
      }
    }
    if (best.is_block()) return best.index();
    n = best.index();
  }
}

}  // namespace

// Prefetches the parent of `home` while the new faces are computed, and grows the box of `home` once.
void replace_faces(TreeStore& tree, const Mesh& mesh, std::span<const FaceId> removed,
                   std::span<const FaceId> added) {
  assert(!removed.empty() && !added.empty());
  const auto stays = [&](FaceId f) { return std::find(added.begin(), added.end(), f) != added.end(); };
  const auto was_there = [&](FaceId f) {
    return std::find(removed.begin(), removed.end(), f) != removed.end();
  };
  assert(tree.place(removed[0]) != kNoIndex);
  const uint32_t home = block_at(tree.place(removed[0]));
  prefetch(tree.blocks[home]);
  size_t next = 0;
  const auto next_added = [&] {
    while (next < added.size() && was_there(added[next])) ++next;
    return next < added.size();
  };
  Positions positions = mesh.positions();
  FloatBox written;
  const auto write = [&](FaceId f, uint32_t lane) {
    const TreeFace face(tree.frame, mesh, positions, f);
    tree.put(face, home, lane);
    written.add(face.box());
  };
  for (const FaceId f : removed) {
    const uint32_t place = tree.place(f);
    assert(place != kNoIndex);
    if (block_at(place) == home) prefetch(tree.nodes[tree.blocks[home].parent]);
    if (stays(f) && block_at(place) == home) {
      write(f, lane_at(place));
    } else if (stays(f)) {
      refit_face(tree, mesh, f);
    } else if (block_at(place) == home && next_added()) {
      tree.set_place(f, kNoIndex);
      write(added[next++], lane_at(place));
    } else {
      remove_face(tree, f);
    }
  }
  for (uint32_t lane = tree.blocks[home].count; lane < kBlockWidth && next_added(); ++lane) {
    tree.set_count(home, lane + 1);
    write(added[next++], lane);
  }
  if (tree.blocks[home].count == 0) return;  // all were removed
  grow_block(tree, home, written);
  while (next_added()) insert_face(tree, TreeFace(tree.frame, mesh, positions, added[next++]), home);
}

void replace_faces(TreeStore& tree, const Mesh& mesh, std::span<const Replacement> all) {
  for (size_t i = 0; i < all.size(); ++i) {
    if (i + kPlaceAhead < all.size()) tree.prefetch_place(all[i + kPlaceAhead].removed[0]);
    if (i + kBlockAhead < all.size()) prefetch_block(tree, all[i + kBlockAhead].removed[0]);
    if (i + kNodeAhead < all.size()) prefetch_node(tree, all[i + kNodeAhead].removed[0]);
    const Replacement& r = all[i];
    replace_faces(tree, mesh, {r.removed.data(), r.removed_count}, {r.added.data(), r.added_count});
  }
}

void add_face(TreeStore& tree, const Mesh& mesh, FaceId f) {
  assert(tree.place(f) == kNoIndex && tree.root != kNoIndex);
  const TreeFace face(tree.frame, mesh, f);
  insert_face(tree, face, block_that_grows_least(tree, face.box()));
}

void remove_face(TreeStore& tree, FaceId f) {
  const uint32_t place = tree.place(f);
  assert(place != kNoIndex);
  tree.set_place(f, kNoIndex);
  const uint32_t b = block_at(place);
  drop_lane(tree, b, lane_at(place));
  const uint32_t parent = tree.blocks[b].parent, slot = tree.blocks[b].slot;
  if (tree.blocks[b].count > 0) {
    tree.set_slot_box(parent, slot, tree.block_box(tree.blocks[b]));
    return shrink_above(tree, parent);
  }
  tree.free_block(b);
  tree.empty_slot(parent, slot);
  settle(tree, parent);
}

void refit_face(TreeStore& tree, const Mesh& mesh, FaceId f) {
  const uint32_t place = tree.place(f);
  assert(place != kNoIndex);
  rewrite_lane(tree, TreeFace(tree.frame, mesh, f), block_at(place), lane_at(place));
}

}  // namespace kerf
