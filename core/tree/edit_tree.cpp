#include "core/tree/edit_tree.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace kerf {

namespace {

uint32_t block_at(uint32_t place) { return place / kBlockWidth; }
uint32_t lane_at(uint32_t place) { return place % kBlockWidth; }

// Boxes upward ----------------------------------------------------------------------------------------------

// Makes the box of the node, and those above it, hold this one.
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

// Fits the boxes of the node and of those above it for as long as they change.
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
  FaceBlock& b = tree.blocks[to];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) b.corner[i][k][to_lane] = a.corner[i][k][from_lane];
    b.vertex[i][to_lane] = a.vertex[i][from_lane];
  }
  b.face[to_lane] = a.face[from_lane];
  const unsigned bit = a.hit >> from_lane & 1u;
  b.hit = static_cast<uint8_t>((b.hit & ~(1u << to_lane)) | bit << to_lane);
  tree.set_place(FaceId(b.face[to_lane]), to * kBlockWidth + to_lane);
}

// The last lane takes the place of the one that goes.
void drop_lane(TreeStore& tree, uint32_t block, uint32_t lane) {
  FaceBlock& b = tree.blocks[block];
  const uint32_t last = b.count - 1u;
  tree.set_count(block, last);
  if (lane != last) copy_lane(tree, block, last, block, lane);
  b.hit = static_cast<uint8_t>(b.hit & ~(1u << last));
}

uint32_t free_slot(const WideNode& node) {
  uint32_t s = 0;
  while (s < kNodeWidth && !node.child[s].none()) ++s;
  return s;
}

// Parting a block -------------------------------------------------------------------------------------------

// How the faces of a full block and one more part in two, along the axis on which their centres spread most.
class Parting {
 public:
  static constexpr uint32_t kCount = kBlockWidth + 1;

  Parting(const TreeStore& tree, const FaceBlock& full, const FloatBox& added) {
    for (uint32_t i = 0; i < kBlockWidth; ++i) box_[i] = tree.face_box(full, i);
    box_[kBlockWidth] = added;
    const int axis = longest_axis();
    for (uint32_t i = 0; i < kCount; ++i) order_[i] = i;
    std::sort(order_.begin(), order_.end(), [&](uint32_t a, uint32_t b) {
      const float x = centre(a, axis), y = centre(b, axis);
      return x != y ? x < y : a < b;
    });
  }

  // The lanes of the part without the added face, as a mask: those stay.
  unsigned staying() const {
    const bool two_first = cost(2) <= cost(3);
    const uint32_t cut = two_first ? 2 : 3;
    unsigned first = 0;
    for (uint32_t i = 0; i < cut; ++i) first |= 1u << order_[i];
    const unsigned all = (1u << kCount) - 1, added = 1u << kBlockWidth;
    return (first & added) != 0 ? all & ~first : first;
  }

 private:
  float centre(uint32_t i, int axis) const { return box_[i].low[axis] + box_[i].high[axis]; }
  int longest_axis() const {
    int longest = 0;
    float most = -1;
    for (int axis = 0; axis < 3; ++axis) {
      float low = centre(0, axis), high = low;
      for (uint32_t i = 1; i < kCount; ++i) {
        low = std::min(low, centre(i, axis));
        high = std::max(high, centre(i, axis));
      }
      if (high - low > most) {
        most = high - low;
        longest = axis;
      }
    }
    return longest;
  }
  float cost(uint32_t cut) const {
    FloatBox first, second;
    for (uint32_t i = 0; i < kCount; ++i) (i < cut ? first : second).add(box_[order_[i]]);
    return first.area() + second.area();
  }

  std::array<FloatBox, kCount> box_;
  std::array<uint32_t, kCount> order_;
};

// Hangs a fresh block beside b: into b's node, or with b into a new node in b's slot.
void hang_beside(TreeStore& tree, uint32_t b, uint32_t fresh) {
  const uint32_t parent = tree.blocks[b].parent, slot = tree.blocks[b].slot;
  const FloatBox stays = tree.block_box(tree.blocks[b]), goes = tree.block_box(tree.blocks[fresh]);
  const bool stays_hit = tree.blocks[b].hit != 0, goes_hit = tree.blocks[fresh].hit != 0;
  const auto mark = [&](uint32_t n, uint32_t s, bool hit) {
    tree.nodes[n].hit = static_cast<uint8_t>(tree.nodes[n].hit | unsigned{hit} << s);
  };
  const uint32_t beside = free_slot(tree.nodes[parent]);
  if (beside < kNodeWidth) {
    tree.set_slot_box(parent, slot, stays);
    tree.hang(parent, beside, Child::block(fresh), goes);
    mark(parent, beside, goes_hit);
    grow_above(tree, parent, goes);
    return;
  }
  const uint32_t n = tree.add_node();
  FloatBox both = stays;
  both.add(goes);
  tree.hang(parent, slot, Child::node(n), both);
  tree.hang(n, 0, Child::block(b), stays);
  tree.hang(n, 1, Child::block(fresh), goes);
  mark(n, 0, stays_hit);
  mark(n, 1, goes_hit);
  grow_above(tree, parent, both);
}

// Writes the face into a lane that is in use.
void rewrite_lane(TreeStore& tree, const Mesh& mesh, FaceId f, uint32_t b, uint32_t lane) {
  tree.write_face(mesh, f, b, lane);
  grow_block(tree, b, tree.face_box(tree.blocks[b], lane));
}

void forget_hit(TreeStore& tree, uint32_t place) {
  FaceBlock& b = tree.blocks[block_at(place)];
  b.hit = static_cast<uint8_t>(b.hit & ~(1u << lane_at(place)));
}

// Adds the face to the block or beside it.
void insert_face(TreeStore& tree, const Mesh& mesh, FaceId f, uint32_t b) {
  if (tree.blocks[b].count < kBlockWidth) {
    const uint32_t lane = tree.blocks[b].count;
    tree.set_count(b, lane + 1);
    tree.write_face(mesh, f, b, lane);
    grow_block(tree, b, tree.face_box(tree.blocks[b], lane));
    return;
  }
  const uint32_t fresh = tree.add_block();
  tree.set_count(fresh, 1);
  tree.write_face(mesh, f, fresh, 0);
  const unsigned staying = Parting(tree, tree.blocks[b], tree.face_box(tree.blocks[fresh], 0)).staying();
  for (uint32_t lane = kBlockWidth; lane-- > 0;) {
    if ((staying >> lane & 1) != 0) continue;
    const uint32_t to = tree.blocks[fresh].count;
    tree.set_count(fresh, to + 1);
    copy_lane(tree, b, lane, fresh, to);
    drop_lane(tree, b, lane);
  }
  hang_beside(tree, b, fresh);
}

// Records that empty ----------------------------------------------------------------------------------------

void remove_root(TreeStore& tree) {
  tree.free_node(tree.root);
  tree.root = kNoIndex;
  tree.set_root_box(FloatBox{});
  tree.root_hit = false;
}

// The only child of a node takes its place. The root stays where the child is a block.
void hoist(TreeStore& tree, uint32_t n, uint32_t slot) {
  const Child child = tree.nodes[n].child[slot];
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

// The node lost a child: it goes or shrinks.
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

}  // namespace

void replace_faces(TreeStore& tree, const Mesh& mesh, std::span<const FaceId> gone,
                   std::span<const FaceId> born) {
  assert(!gone.empty() && !born.empty());
  const auto stays = [&](FaceId f) { return std::find(born.begin(), born.end(), f) != born.end(); };
  const auto was_there = [&](FaceId f) { return std::find(gone.begin(), gone.end(), f) != gone.end(); };
  const uint32_t home = block_at(tree.place(gone[0]));
  for (const FaceId f : gone) {
    forget_hit(tree, tree.place(f));
    if (stays(f)) refit_face(tree, mesh, f);
  }
  uint32_t next = 0;
  // Lanes that are free now take the first of the others.
  const auto next_born = [&] {
    while (next < born.size() && was_there(born[next])) ++next;
    return next < born.size();
  };
  for (const FaceId f : gone) {
    if (stays(f)) continue;
    const uint32_t place = tree.place(f);
    if (block_at(place) != home || !next_born()) {
      remove_face(tree, f);
      continue;
    }
    tree.set_place(f, kNoIndex);
    rewrite_lane(tree, mesh, born[next++], home, lane_at(place));
  }
  while (next_born()) insert_face(tree, mesh, born[next++], home);
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
  rewrite_lane(tree, mesh, f, block_at(place), lane_at(place));
}

}  // namespace kerf
