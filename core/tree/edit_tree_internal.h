#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/tree/tree_internal.h"

namespace kerf {

// Steps of the edits of a tree.

// Enlarges the box of a node and those above it to hold `box`.
void grow_above(TreeStore& tree, uint32_t node, const FloatBox& box);
// Recomputes the boxes of a node and its ancestors up to the first unchanged one.
void shrink_above(TreeStore& tree, uint32_t node);
// Fits the boxes of a block, which has lost faces, and of its ancestors. Removes the block if it is empty.
void shrink_block(TreeStore& tree, uint32_t block);
// Removes the face in a lane of a block and moves the face of the last lane into it.
void drop_lane(TreeStore& tree, uint32_t block, uint32_t lane);

// Adds faces to blocks. An overflowing block is divided at the medians of the centres of the faces' boxes,
// along the longest axis, into blocks as full as possible, which become siblings. If its node is full, half
// of the node's children move to a new sibling of it; if there is no room for that either, the blocks get a
// new node in the place of the first one.
class BlockFiller {
 public:
  explicit BlockFiller(TreeStore& tree) : tree_(tree) {}

  // Adds faces to a block and fits its box. Enlarges the boxes above if necessary. Preconditions: the faces
  // are not in the tree, and there is at least one.
  void fill(uint32_t block, std::span<const TreeFace> faces);

 private:
  struct Boxed {
    Child child;
    FloatBox box;
  };
  void start(size_t items);
  size_t divide(std::span<uint32_t> items, size_t parts);
  void close_blocks(uint32_t first, std::span<uint32_t> faces);
  void close_block(uint32_t block, std::span<const uint32_t> faces);
  void gather_in_nodes();
  void hang(uint32_t parent, uint32_t slot);
  void divide_node(uint32_t node, uint32_t above, uint32_t free_slot);

  TreeStore& tree_;
  std::vector<TreeFace> faces_;
  std::vector<Boxed> children_;   // to be hung
  std::vector<uint32_t> items_;   // indices of faces or children, divided in place
  std::vector<Float4> centres2_;  // twice the centres of their boxes
};

}  // namespace kerf
