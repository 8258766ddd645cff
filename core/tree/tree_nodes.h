#pragma once

#include <cstdint>

#include "core/base/ids.h"

namespace kerf {

// The two kinds of record of a tree.

inline constexpr uint32_t kNodeWidth = 8;
inline constexpr uint32_t kBlockWidth = 4;

// The content of a slot of a node: nothing, another node, or a block of faces.
struct Child {
  static constexpr uint32_t kBlockBit = 0x80000000u;
  uint32_t bits = kNoIndex;

  static Child node(uint32_t index) { return {index}; }
  static Child block(uint32_t index) { return {index | kBlockBit}; }
  bool none() const { return bits == kNoIndex; }
  // Precondition: !none().
  bool is_block() const { return (bits & kBlockBit) != 0; }
  uint32_t index() const { return bits & ~kBlockBit; }
};

// A node: the boxes of up to eight children as a structure of arrays, by plane (low x y z, high x y z). The
// box of an empty slot is empty, so that no query meets it.
struct alignas(64) WideNode {
  float plane[6][kNodeWidth];
  Child child[kNodeWidth];
  uint32_t parent;  // kNoIndex at the root; in a free record the next free one
  uint8_t slot;     // in the parent
};
static_assert(sizeof(WideNode) == 256);

// A block of up to four faces in the first `count` lanes: their corners, rounded to the nearest floats in the
// frame of the tree, and the vertices of the mesh at these corners. Culling reads only the first three cache
// lines.
struct alignas(32) FaceBlock {
  float corner[3][3][kBlockWidth];  // by corner, axis, lane
  uint32_t parent;                  // of a free record the next free one
  uint8_t slot;                     // in the parent
  uint8_t count;
  uint32_t face[kBlockWidth];
  uint32_t vertex[3][kBlockWidth];
};
static_assert(sizeof(FaceBlock) == 224);

}  // namespace kerf
