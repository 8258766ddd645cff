#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/ids.h"

namespace kerf {

inline constexpr uint32_t kNodeWidth = 8;
inline constexpr uint32_t kBlockWidth = 4;

// The content of a slot of a node: empty, a node, or a block of faces.
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

// A node: the boxes of up to eight children as a structure of arrays, by plane (low x y z, high x y z). An
// empty slot has an empty box, which no query hits.
struct alignas(64) WideNode {
  float plane[6][kNodeWidth];
  Child child[kNodeWidth];
  uint32_t parent;  // kNoIndex at the root; the next free record in a free one
  uint8_t slot;     // in the parent
};
static_assert(sizeof(WideNode) == 256);

// A block of up to four faces in the first `count` lanes: their corners, rounded to the nearest floats in the
// frame of the tree, and the vertices of the mesh at these corners. Culling reads only the first three cache
// lines.
struct alignas(32) FaceBlock {
  float corner[3][3][kBlockWidth];  // by corner, axis, lane
  uint32_t parent;                  // the next free record in a free one
  uint8_t slot;                     // in the parent
  uint8_t count;
  uint16_t change;  // used within a batch of replacements, else 0
  uint32_t face[kBlockWidth];
  uint32_t vertex[3][kBlockWidth];
};
static_assert(sizeof(FaceBlock) == 224);

// The cyclic successor of each axis.
inline constexpr int kNextAxis[] = {1, 2, 0};
// Results of longest_axis, indexed by its three comparisons.
inline constexpr int kLongestAxis[] = {0, 0, 1, 0, 2, 2, 1, 0};

// Returns the index of the largest of three absolute components, the first of equal ones, without branches.
template <typename T>
[[gnu::always_inline]] inline int longest_axis(T x, T y, T z) {
  return kLongestAxis[unsigned{x >= y} | unsigned{y >= z} << 1 | unsigned{z > x} << 2];
}

// The instruction set that traversals of a tree use. Results do not depend on it.
enum class Simd : uint8_t {
  kPlain,  // that of the compiler, for any processor
  kSse4,
  kAvx2,  // with fused multiply-add
};

// Returns true if this build contains the traversals and the processor can execute them.
bool is_supported(Simd simd);
// Returns the best supported instruction set that GLIBC_TUNABLES does not disable.
Simd best_simd();
// Returns the instruction set named "plain", "sse4" or "avx2"; nullopt for any other name.
std::optional<Simd> simd_named(std::string_view name);
// Returns the instruction set that the environment variable KERF_SIMD names, if it is supported, else the
// best one. Reads the environment once.
Simd selected_simd();

// Tree traversals cull in single precision and list the faces that may be results. Each traversal is a
// template over vector types (see walk_code.h), compiled once per instruction set. Sources compiled for a
// newer instruction set share only plain data and always-inlined functions with the rest of the program, so
// that the linker never picks a copy of a shared function that older processors cannot execute.

// The records of a tree.
struct TreeView {
  static constexpr uint32_t kShift = 16;  // log2 of the records in a chunk; see Records
  const WideNode* const* nodes;
  const FaceBlock* const* blocks;
  uint32_t root;
};

// A list of words; its owner provides the storage.
struct WordList {
  uintptr_t* items;
  uint32_t count;
  uint32_t capacity;
};

// A face in the lists of a traversal: the address of its block, which is a multiple of 32, plus its lane,
// plus four times the index of the ray.
[[gnu::always_inline]] inline uintptr_t face_word(const FaceBlock* block, unsigned lane, unsigned ray = 0) {
  return reinterpret_cast<uintptr_t>(block) + lane + 4 * ray;
}
[[gnu::always_inline]] inline const FaceBlock* block_of(uintptr_t word) {
  return reinterpret_cast<const FaceBlock*>(word & ~uintptr_t{31});
}
[[gnu::always_inline]] inline unsigned lane_of(uintptr_t word) { return word & 3; }
[[gnu::always_inline]] inline unsigned ray_of(uintptr_t word) { return word >> 2 & 7; }

// The lists of a traversal. `grow` doubles the capacity of one of them.
struct WalkLists {
  WordList nodes, blocks, faces, boxes;
  void (*grow)(WalkLists&, WordList&);
};

// Parallel rays, prepared for tests against boxes and triangles, in the frame of the tree. The parameter t is
// the distance from a point in front of all boxes, so that it is positive within the tree.
struct RayQuery {
  // Slab test, by axis: the planes of a box by which the ray enters and leaves, and the terms of t = plane *
  // slope - offset, all rounded so that no box is missed. Fourth elements are padding.
  alignas(16) uint32_t near_plane[4];
  alignas(16) uint32_t far_plane[4];
  alignas(16) float near_slope[4];
  alignas(16) float far_slope[4];
  alignas(16) float near_offset[4];
  alignas(16) float far_offset[4];
  float t_low, t_high;
  float t_sure;  // hits at this t or beyond certainly satisfy the lower end of the range
  // Triangle test: the common direction, and for each ray its point nearest to the origin of the frame.
  alignas(16) float direction[4];
  alignas(16) float passing[kBlockWidth][4];
  float error;  // bound of the error of a sheared coordinate
  uint32_t rays;
  // The positions of the mesh's vertices by chunk, three doubles each, prefetched for the caller's exact test
  // of listed faces.
  static constexpr uint32_t kPositionShift = 19;
  const char* const* positions;
};

// An oriented box in the frame of the tree: for each axis the interval that a projection must meet.
struct SlabQuery {
  struct Axis {
    // The planes of an axis-aligned box with the minimum and maximum projection onto this axis.
    uint32_t low_plane[3], high_plane[3];
    float direction[3];
    float low, high;
  };
  Axis axis[3];
};

// The traversals for one instruction set. Precondition of each: the tree has a root.
struct Walks {
  // Lists the faces that the ray may cross, in an order that depends only on the tree.
  void (*ray)(const TreeView&, const RayQuery&, WalkLists&);
  // Lists the faces that any of up to four parallel rays may cross.
  void (*rays)(const TreeView&, const RayQuery&, WalkLists&);
  // Lists candidates for the first face that the ray crosses, which is among them; visits near boxes first.
  void (*nearest)(const TreeView&, const RayQuery&, WalkLists&);
  // Lists the faces that may meet the oriented box, and in `boxes` those whose boxes may. Returns the number
  // of boxes tested.
  uint64_t (*slab)(const TreeView&, const SlabQuery&, WalkLists&);
};

const Walks& walks_plain();
const Walks& walks_sse4();
const Walks& walks_avx2();
// Precondition: is_supported(simd).
const Walks& walks_for(Simd simd);

}  // namespace kerf
