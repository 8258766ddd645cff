#pragma once

#include <cstddef>
#include <cstdint>

#include "core/tree/simd.h"
#include "core/tree/tree_nodes.h"

namespace kerf {

// The walks through a tree: they cull in floats and hand over the faces that may be what is asked for. Each
// is written once, over lanes of floats, and compiled for each kind of processor. All that these sources
// share with others is in this header: plain data, and functions that are always inlined. So no function that
// was compiled for a newer processor is linked into code for all.

// The records of a tree.
struct TreeView {
  static constexpr uint32_t kShift = 16;  // of Records
  const WideNode* const* nodes;
  const FaceBlock* const* blocks;
  uint32_t root;
};

// A list of words in storage of its owner.
struct WordList {
  uintptr_t* items;
  uint32_t count;
  uint32_t capacity;
};

// A face as the walks name it: its block's address, which is a multiple of 32, plus its lane; in a walk of
// several rays plus four times the ray.
[[gnu::always_inline]] inline uintptr_t face_word(const FaceBlock* block, unsigned lane, unsigned ray = 0) {
  return reinterpret_cast<uintptr_t>(block) + lane + 4 * ray;
}
[[gnu::always_inline]] inline const FaceBlock* block_of(uintptr_t word) {
  return reinterpret_cast<const FaceBlock*>(word & ~uintptr_t{31});
}
[[gnu::always_inline]] inline unsigned lane_of(uintptr_t word) { return word & 3; }
[[gnu::always_inline]] inline unsigned ray_of(uintptr_t word) { return word >> 2 & 7; }

// A record that the beam meets in slots or lanes where it never was: two words, the first the record's
// address, plus one for a block.
[[gnu::always_inline]] inline bool marks_block(uintptr_t word) { return (word & 1) != 0; }

// What a walk lists. The owner doubles the capacity of a list.
struct WalkLists {
  WordList nodes, blocks, faces, marks;
  void (*grow)(WalkLists&, WordList&);
};

// Parallel rays against boxes and triangles. `t` is measured along the direction from a point before all
// boxes, so that it is positive where it matters.
struct RayQuery {
  // Slabs: by axis the planes that the ray meets first and last, what is taken off them and what the rest is
  // multiplied with, all rounded so that no box is missed.
  alignas(16) uint32_t near_plane[4];  // of the fourth only the place counts, here and below
  alignas(16) uint32_t far_plane[4];
  alignas(16) float near_origin[4];
  alignas(16) float far_origin[4];
  alignas(16) float near_slope[4];
  alignas(16) float far_slope[4];
  float t_low, t_high;
  float t_sure;  // from which t on a hit is within the range for sure, at its near end
  // Triangles: where the rays go, and where each passes the origin.
  alignas(16) float direction[4];
  alignas(16) float passing[kBlockWidth][4];
  float error;  // of a sheared coordinate
  uint32_t rays;
  // The positions of the mesh's vertices, three doubles each, by chunk: what a face that is listed will be
  // decided with.
  static constexpr uint32_t kPositionShift = 19;
  const char* const* positions;
};

// A box of any orientation: by its axes, the interval that a projection must meet.
struct SlabQuery {
  struct Axis {
    uint32_t low_plane[3], high_plane[3];  // of a box, whose sum of products is least, and largest
    float direction[3];
    float low, high;
  };
  Axis axis[3];
};

struct Walks {
  // Lists the faces that a ray may cross.
  void (*ray)(const TreeView&, const RayQuery&, WalkLists&);
  // The same for up to four parallel rays.
  void (*rays)(const TreeView&, const RayQuery&, WalkLists&);
  // Lists faces of which one is the first that the ray crosses, near boxes first.
  void (*nearest)(const TreeView&, const RayQuery&, WalkLists&);
  // Lists the faces that may meet the box, and what to mark: slots and lanes whose boxes may. Returns how
  // many boxes it looked at.
  uint64_t (*slab)(const TreeView&, const SlabQuery&, WalkLists&);
};

const Walks& walks_sse4();
const Walks& walks_avx2();
inline const Walks& walks_for(Simd simd) { return simd == Simd::kAvx2 ? walks_avx2() : walks_sse4(); }

}  // namespace kerf
