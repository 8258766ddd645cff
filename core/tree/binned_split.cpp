#include "core/tree/binned_split.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/base/assert.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"

namespace kerf {

namespace {

constexpr int kMostBins = 16;

// Maps a centroid to its bin along each axis.
class Binning {
 public:
  Binning(const PrimitiveRange& range)
      : count(static_cast<int>(std::min<size_t>(kMostBins, 4 + range.items.size() / 8))),
        low_(range.centres.low) {
    const __m128 size = _mm_sub_ps(range.centres.high, low_);
    const __m128 scale = _mm_div_ps(_mm_set1_ps(kBinScale * static_cast<float>(count)), size);
    spread_ = _mm_cmpgt_ps(size, _mm_set1_ps(kLeastSpread));
    scale_ = _mm_and_ps(scale, spread_);
  }

  __m128i bins_of(const Primitive& p) const {
    return _mm_cvttps_epi32(_mm_mul_ps(_mm_sub_ps(p.centre2(), low_), scale_));
  }
  bool spreads(int axis) const { return (_mm_movemask_ps(spread_) >> axis & 1) != 0; }

  const int count;

 private:
  __m128 low_, scale_, spread_;
};

struct Bin {
  FloatBox box;
  uint32_t count = 0;
};

struct Plane {
  int axis = -1;
  int bin = 0;  // the first bin of the right part
  float cost = std::numeric_limits<float>::infinity();
};

// The primitives of a range by bin, along each axis.
struct Bins {
  Bin bin[3][kMostBins];

  void put(std::span<const Primitive> items, const Binning& binning) {
    for (const Primitive& p : items) {
      const __m128i at = binning.bins_of(p);
      put(bin[0][_mm_extract_epi32(at, 0)], p);
      put(bin[1][_mm_extract_epi32(at, 1)], p);
      put(bin[2][_mm_extract_epi32(at, 2)], p);
    }
  }
  void add(const Bins& other, int count) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < count; ++i) {
        bin[axis][i].box.add(other.bin[axis][i].box);
        bin[axis][i].count += other.bin[axis][i].count;
      }
    }
  }

 private:
  static void put(Bin& bin, const Primitive& p) {
    bin.box.add(p.low, p.high);
    ++bin.count;
  }
};

// Large ranges are sorted into bins on several threads.
Bins sort_into_bins(std::span<const Primitive> items, const Binning& binning) {
  constexpr size_t kItems = 1 << 16;  // a range
  if (items.size() <= kItems) {
    Bins bins;
    bins.put(items, binning);
    return bins;
  }
  std::vector<Bins> parts(range_count(items.size(), kItems));
  for_each_range(items.size(), kItems, [&](size_t first, size_t end) {
    parts[first / kItems].put(items.subspan(first, end - first), binning);
  });
  for (size_t i = 1; i < parts.size(); ++i) parts[0].add(parts[i], binning.count);
  return parts[0];
}

class BinSweep {
 public:
  BinSweep(const PrimitiveRange& range, const Binning& binning, uint32_t block)
      : binning_(binning), block_(block), bins_(sort_into_bins(range.items, binning)) {}

  Plane best() const {
    Plane best;
    for (int axis = 0; axis < 3; ++axis) {
      if (binning_.spreads(axis)) sweep(axis, best);
    }
    return best;
  }

 private:
  float cost(const FloatBox& box, uint32_t count) const {
    return count == 0 ? 0 : box.area() * static_cast<float>((count + block_ - 1) / block_);
  }

  void sweep(int axis, Plane& best) const {
    const Bin* bins = bins_.bin[axis];
    float right_cost[kMostBins];
    Bin right, left;
    for (int i = binning_.count - 1; i > 0; --i) {
      right.box.add(bins[i].box);
      right.count += bins[i].count;
      right_cost[i] =
          right.count == 0 ? std::numeric_limits<float>::infinity() : cost(right.box, right.count);
    }
    for (int i = 1; i < binning_.count; ++i) {
      left.box.add(bins[i - 1].box);
      left.count += bins[i - 1].count;
      if (left.count == 0) continue;
      const float total = cost(left.box, left.count) + right_cost[i];
      if (total < best.cost) best = {axis, i, total};
    }
  }

  const Binning& binning_;
  uint32_t block_;
  Bins bins_;
};

// Reorders the items so that those for which `is_left` holds come first.
template <typename IsLeft>
RangePair partition(const PrimitiveRange& range, IsLeft is_left) {
  RangePair parts;
  Primitive *first = range.items.data(), *left = first, *right = first + range.items.size();
  while (left < right) {
    if (is_left(*left)) {
      parts.left.add(*left++);
    } else {
      --right;
      parts.right.add(*left);
      std::swap(*left, *right);
    }
  }
  const auto at = static_cast<size_t>(left - first);
  parts.left.items = range.items.first(at);
  parts.right.items = range.items.subspan(at);
  return parts;
}

}  // namespace

RangePair split_in_half(const PrimitiveRange& range) {
  KERF_ASSERT(range.items.size() >= 2);
  const size_t middle = range.items.size() / 2;
  RangePair parts;
  parts.left.items = range.items.first(middle);
  parts.right.items = range.items.subspan(middle);
  for (const Primitive& p : parts.left.items) parts.left.add(p);
  for (const Primitive& p : parts.right.items) parts.right.add(p);
  return parts;
}

RangePair split_binned(const PrimitiveRange& range, uint32_t block) {
  KERF_ASSERT(range.items.size() >= 2 && block > 0);
  const Binning binning(range);
  const Plane plane = BinSweep(range, binning, block).best();
  if (plane.axis < 0) return split_in_half(range);
  const __m128i bin = _mm_set1_epi32(plane.bin);
  return partition(range, [&](const Primitive& p) {
    const __m128i below = _mm_cmplt_epi32(binning.bins_of(p), bin);
    return (_mm_movemask_ps(_mm_castsi128_ps(below)) >> plane.axis & 1) != 0;
  });
}

}  // namespace kerf
