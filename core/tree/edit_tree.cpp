#include <cassert>
#include <utility>

#include "core/tree/edit_tree_internal.h"

namespace kerf {

// Boxes upward ----------------------------------------------------------------------------------------------

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

void shrink_above(TreeStore& tree, uint32_t n) {
  for (; n != tree.root; n = tree.nodes[n].parent) {
    const WideNode& node = tree.nodes[n];
    const FloatBox fitted = tree.node_box(node);
    if (fitted == tree.slot_box(node.parent, node.slot)) return;
    tree.set_slot_box(node.parent, node.slot, fitted);
  }
  tree.set_root_box(tree.node_box(tree.nodes[n]));
}

// Removing records ----------------------------------------------------------------------------------------

void drop_lane(TreeStore& tree, uint32_t block, uint32_t lane) {
  FaceBlock& b = tree.blocks.edit(block);
  assert(lane < b.count);
  const uint32_t last = b.count - 1u;
  tree.set_place(FaceId(b.face[lane]), kNoIndex);
  tree.set_count(block, last);
  if (lane == last) return;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) b.corner[i][k][lane] = b.corner[i][k][last];
    b.vertex[i][lane] = b.vertex[i][last];
  }
  b.face[lane] = b.face[last];
  tree.set_place(FaceId(b.face[lane]), block * kBlockWidth + lane);
}

namespace {

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

// Returns the lowest node above a block whose box holds another one, or the root.
uint32_t node_around(const TreeStore& tree, uint32_t block, const FloatBox& box) {
  uint32_t n = tree.blocks[block].parent;
  while (n != tree.root && !tree.slot_box(tree.nodes[n].parent, tree.nodes[n].slot).holds(box))
    n = tree.nodes[n].parent;
  return n;
}

// Returns the block found from a node by following the slot whose box grows least with the added box.
uint32_t block_that_grows_least(const TreeStore& tree, uint32_t n, const FloatBox& added) {
  for (;;) {
    const WideNode& node = tree.nodes[n];
    Child best;
    std::pair<float, float> least;  // how much the box grows, and how large it is then
    for (uint32_t s = 0; s < kNodeWidth; ++s) {
      if (node.child[s].none()) continue;
      const FloatBox own = tree.slot_box(n, s);
      FloatBox both = own;
      both.add(added);
      const std::pair cost(both.area() - own.area(), both.area());
      if (best.none() || cost < least) {
        best = node.child[s];
        least = cost;
      }
    }
    assert(!best.none());
    if (best.is_block()) return best.index();
    n = best.index();
  }
}

}  // namespace

void shrink_block(TreeStore& tree, uint32_t b) {
  const uint32_t parent = tree.blocks[b].parent, slot = tree.blocks[b].slot;
  if (tree.blocks[b].count > 0) {
    tree.set_slot_box(parent, slot, tree.block_box(tree.blocks[b]));
    return shrink_above(tree, parent);
  }
  tree.free_block(b);
  tree.empty_slot(parent, slot);
  settle(tree, parent);
}

void add_faces(TreeStore& tree, const Mesh& mesh, std::span<const FaceId> faces) {
  BlockFiller filler(tree);
  uint32_t latest = kNoIndex;  // block
  for (const FaceId f : faces) {
    assert(tree.place(f) == kNoIndex && tree.root != kNoIndex);
    const TreeFace face(tree.frame, mesh, f);
    const FloatBox box = face.box();
    const uint32_t n = latest == kNoIndex ? tree.root : node_around(tree, latest, box);
    filler.fill(block_that_grows_least(tree, n, box), {&face, 1});
    latest = tree.place(f) / kBlockWidth;
  }
}

void remove_face(TreeStore& tree, FaceId f) {
  const uint32_t place = tree.place(f);
  assert(place != kNoIndex);
  drop_lane(tree, place / kBlockWidth, place % kBlockWidth);
  shrink_block(tree, place / kBlockWidth);
}

void refit_face(TreeStore& tree, const Mesh& mesh, FaceId f) {
  const uint32_t place = tree.place(f), b = place / kBlockWidth;
  assert(place != kNoIndex);
  const TreeFace face(tree.frame, mesh, f);
  tree.put(face, b, place % kBlockWidth);
  const uint32_t parent = tree.blocks[b].parent, slot = tree.blocks[b].slot;
  FloatBox own = tree.slot_box(parent, slot);
  if (own.holds(face.box())) return;
  own.add(face.box());
  tree.set_slot_box(parent, slot, own);
  grow_above(tree, parent, face.box());
}

}  // namespace kerf
