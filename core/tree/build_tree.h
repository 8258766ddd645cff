#pragma once

#include <atomic>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <thread>

#include "core/base/parallel.h"
#include "core/tree/tree_store.h"

namespace kerf {

// Progress of sorting faces on several threads; only the thread that constructed this object reports it. The
// work of sorting n faces is modelled as n log2 n, so a split completes the difference between its range and
// both parts.
class SortProgress {
 public:
  // `progress` may be null; it must outlive this object.
  SortProgress(const Progress* progress, size_t faces);

  void record_split(size_t whole, size_t left, size_t right);
  void record_done(size_t faces);
  bool stopped() const { return stopped_; }

 private:
  void note(double done);

  const Progress* progress_;
  std::thread::id owner_;
  double all_;
  double next_ = 0;  // completed work at which the owner reports next
  std::atomic<double> done_ = 0;
  std::atomic<bool> stopped_ = false;
};

// The bounding box of a face during construction. The fourth lane of `low` holds the face's number.
struct Primitive {
  static constexpr uint32_t kNumberTag = 0x40000000u;
  Float4 low, high;

  // The number is encoded as a float that is neither subnormal nor infinite, to keep arithmetic on the lane
  // fast. Precondition: number < 2^29.
  static Primitive make(const FloatBox& box, uint32_t number) {
    assert(number < 1u << 29);
    Primitive made{box.low, box.high};
    made.low[3] = std::bit_cast<float>(number | kNumberTag);
    return made;
  }
  uint32_t number() const { return static_cast<uint32_t>(std::bit_cast<Int4>(low)[3]) & ~kNumberTag; }
  Float4 centre2() const { return low + high; }
};

// Consecutive primitives with their bounding box and that of their centres.
struct PrimitiveRange {
  std::span<Primitive> items;
  FloatBox bounds;
  FloatBox centres;  // bounds of centre2()

  void add(const Primitive& p) {
    bounds.add(p.low, p.high);
    centres.add(p.centre2(), p.centre2());
  }
};

struct RangePair {
  PrimitiveRange left, right;
};
// Splits a range at the plane with the least cost by the surface area heuristic over binned centroids; the
// cost of a part is its area times the number of blocks of `block` primitives that it fills. Reorders the
// items. Splits at the middle if all centroids coincide. Preconditions: the range holds at least two
// primitives, block > 0. O(n).
RangePair split_binned(const PrimitiveRange& range, uint32_t block);
// Splits a range in the middle of its items, in their given order. Precondition: it holds at least two
// primitives. O(n).
RangePair split_in_half(const PrimitiveRange& range);

// The shape of a tree; the default gives the fastest queries.
struct TreeShape {
  uint32_t block = kBlockWidth;  // maximum number of faces in a block, 1 .. kBlockWidth
  bool halved = false;           // splits ranges at their middle, in the given order
};

// Builds a tree over the live faces of a mesh, top-down: the child with the largest area is split by
// split_binned until the node is full (I. Wald: On fast construction of SAH-based bounding volume
// hierarchies, 2007). O(n log n). `progress` may be null. Returns false when stopped; the store must be
// discarded then. Precondition: the store is empty.
bool build_tree(TreeStore& store, const Mesh& mesh, const TreeFrame& frame, const Progress* progress,
                TreeShape shape = {});

}  // namespace kerf
