#pragma once

#include <cstdint>

namespace kerf {

// The two kinds of record that a tree consists of, as the walks read them.

inline constexpr uint32_t kNoIndex = 0xffffffffu;
inline constexpr uint32_t kNodeWidth = 8;
inline constexpr uint32_t kBlockWidth = 4;

// What hangs in a slot of a node: nothing, another node, or a block of faces.
struct Child {
  static constexpr uint32_t kBlockBit = 0x80000000u;
  uint32_t bits = kNoIndex;

  static Child node(uint32_t index) { return {index}; }
  static Child block(uint32_t index) { return {index | kBlockBit}; }
  bool none() const { return bits == kNoIndex; }
  bool is_block() const { return (bits & kBlockBit) != 0; }  // of a child that is there
  uint32_t index() const { return bits & ~kBlockBit; }
};

// Up to eight boxes side by side, by plane: low x y z, high x y z. An empty slot has a box that nothing
// meets.
struct alignas(64) WideNode {
  float plane[6][kNodeWidth];
  Child child[kNodeWidth];
  uint32_t parent;  // kNoIndex at the root; of a free record the next free one
  uint8_t slot;     // in the parent
  uint8_t hit;      // one bit a slot: the beam is or was in its box
};
static_assert(sizeof(WideNode) == 256);

// Up to four faces, the first `count` lanes: corners rounded to the nearest float of the tree's frame, and
// which vertices of the mesh they are. What culling reads stands in the first three cache lines.
struct alignas(32) FaceBlock {
  float corner[3][3][kBlockWidth];  // by corner, axis, lane
  uint32_t parent;                  // of a free record the next free one
  uint8_t slot;                     // in the parent
  uint8_t count;
  uint8_t hit;  // one bit a lane
  uint32_t face[kBlockWidth];
  uint32_t vertex[3][kBlockWidth];
};
static_assert(sizeof(FaceBlock) == 224);

}  // namespace kerf
