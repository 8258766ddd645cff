#include "core/tree/build_tree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/assert.h"
#include "core/base/tolerances.h"

namespace kerf {

namespace {

double need(size_t faces) {
  return faces < 2 ? 0 : static_cast<double>(faces) * std::log2(static_cast<double>(faces));
}

constexpr int kMaxBins = 16;

// Maps a centroid to its bin along each axis.
class Binning {
 public:
  Binning(const PrimitiveRange& range)
      : count(static_cast<int>(std::min<size_t>(kMaxBins, 4 + range.items.size() / 8))),
        low_(range.centres.low) {
    const Float4 size = range.centres.high - low_;
    spread_ = size > all_lanes(kMinSpread);
    scale_ = spread_ ? kBinScale * static_cast<float>(count) / size : all_lanes(0.0f);
  }

  Int4 bins_of(const Primitive& p) const {
    return __builtin_convertvector((p.centre2() - low_) * scale_, Int4);
  }
  bool spreads(int axis) const { return spread_[axis] != 0; }

  const int count;

 private:
  Float4 low_, scale_;
  Int4 spread_;
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
  Bin bin[3][kMaxBins];

  void put(std::span<const Primitive> items, const Binning& binning) {
    for (const Primitive& p : items) {
      const Int4 at = binning.bins_of(p);
      for (int axis = 0; axis < 3; ++axis) put(bin[axis][at[axis]], p);
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
    float right_cost[kMaxBins];
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

constexpr size_t kFacesABlock = 3;

constexpr size_t kGathered = 1 << 14;  // face slots a range
// Ranges of more faces than this are divided among threads; each smaller one is the work of one thread.
constexpr size_t kOneThread = 1 << 14;
// Ranges of at least this many faces report progress at each split, smaller ones when they are finished.
constexpr size_t kSmallRange = 4096;
constexpr double kGathering = 0.13, kSorting = 0.67;  // of the time; the rest is writing

// A block that is still a range of the sorted faces.
struct PlannedBlock {
  uint32_t first, count;  // primitives
  uint32_t parent, slot;  // parent among the nodes of the same part
};

// A part of the tree under construction, whose records will be consecutive. A large one is a node over
// smaller parts. A small one holds its nodes and blocks, depth-first and numbered from 0, or a single block.
struct Part {
  PrimitiveRange range;
  std::vector<Part> children;
  std::vector<WideNode> nodes;
  std::vector<PlannedBlock> blocks;
  uint32_t first_node = 0, first_block = 0;  // in the store

  bool is_block() const { return children.empty() && nodes.empty(); }
  Child child() const { return is_block() ? Child::block(first_block) : Child::node(first_node); }
};

class TreeBuilder {
 public:
  TreeBuilder(TreeStore& store, const Mesh& mesh, TreeShape shape, const Progress* progress)
      : store_(store),
        mesh_(mesh),
        shape_(shape),
        gathering_(share_of(progress, 0, kGathering)),
        sorting_(share_of(progress, kGathering, kGathering + kSorting)),
        writing_(share_of(progress, kGathering + kSorting, 1)),
        sorted_(&sorting_, mesh.live_faces()) {}

  // Returns false if it was stopped.
  bool run() {
    if (!gather()) return false;
    KERF_ASSERT(primitives_.size() == mesh_.live_faces());
    if (primitives_.empty()) return true;
    Part whole;
    whole.range.items = primitives_;
    for (const Primitive& p : primitives_) whole.range.add(p);
    if (primitives_.size() > kOneThread)
      divide(whole);
    else
      build_node(whole, whole.range);
    if (sorted_.stopped()) return false;
    number(whole);
    store_.nodes.grow_to(nodes_);
    store_.blocks.grow_to(blocks_);
    store_.root = whole.first_node;
    if (!write(whole)) return false;
    for (const uint32_t b : singles_) store_.set_count(b, 1);
    store_.set_root_box(store_.node_box(store_.nodes[store_.root]));
    return true;
  }

 private:
  bool gather() {
    std::vector<uint32_t> before(range_count(mesh_.face_slots(), kGathered) + 1);
    const auto live = [&](size_t f) { return mesh_.is_live(FaceId(static_cast<uint32_t>(f))); };
    for_each_range(mesh_.face_slots(), kGathered, [&](size_t f, size_t end) {
      uint32_t& count = before[f / kGathered + 1];
      for (; f < end; ++f) count += live(f);
    });
    for (size_t r = 1; r < before.size(); ++r) before[r] += before[r - 1];
    primitives_.resize(before.back());
    return for_each_range(mesh_.face_slots(), kGathered, &gathering_, [&](size_t f, size_t end) {
      uint32_t to = before[f / kGathered];
      for_each_batch(mesh_, f, end, [&](const TriangleBatch& batch) {
        for (uint32_t i = 0; i < batch.count(); ++i)
          primitives_[to++] = Primitive::make(TreeFace(store_.frame, batch, i).box(), batch.face(i).index);
      });
    });
  }

  struct Children {
    std::array<PrimitiveRange, kNodeWidth> range;
    uint32_t count = 1;

    // Returns the child of the largest area with more than `more_than` and at most `at_most` faces, or null.
    PrimitiveRange* largest(size_t more_than, size_t at_most) {
      PrimitiveRange* best = nullptr;
      for (uint32_t i = 0; i < count; ++i) {
        const size_t faces = range[i].items.size();
        if (faces <= more_than || faces > at_most) continue;
        if (!best || range[i].bounds.area() > best->bounds.area()) best = &range[i];
      }
      return best;
    }
    void split(PrimitiveRange* child, TreeShape shape) {
      assert(count < kNodeWidth);
      const RangePair parts = shape.halved ? split_in_half(*child) : split_binned(*child, shape.block);
      *child = parts.left;
      range[count++] = parts.right;
    }
  };

  // Splits the child of the largest area until the node is full or each child is small enough to be a node of
  // blocks only. The remaining slots receive the blocks of such children directly if all blocks of a child
  // fit, because visiting a node with few blocks costs as much as visiting a full one.
  Children open(const PrimitiveRange& range) {
    Children c;
    c.range[0] = range;
    const size_t faces = range.items.size();
    const bool of_blocks = faces <= kNodeWidth * shape_.block;
    while (c.count < kNodeWidth) {
      PrimitiveRange* child = c.largest(of_blocks ? shape_.block : kNodeWidth * shape_.block, faces);
      if (!child) child = c.largest(shape_.block, (kNodeWidth - c.count + 1) * kFacesABlock);
      if (!child || sorted_.stopped()) break;
      if (faces < kSmallRange)
        c.split(child, shape_);
      else
        split(c, child);
    }
    return c;
  }

  void split(Children& c, PrimitiveRange* child) {
    const size_t whole = child->items.size();
    c.split(child, shape_);
    const size_t left = child->items.size();
    sorted_.record_split(whole, left, whole - left);
  }

  void divide(Part& part) {
    const Children c = open(part.range);
    part.children.resize(c.count);
    for (uint32_t i = 0; i < c.count; ++i) part.children[i].range = c.range[i];
    for_each_range(c.count, 1, [&](size_t i, size_t) { plan(part.children[i]); });
  }

  void plan(Part& part) {
    const size_t faces = part.range.items.size();
    if (sorted_.stopped()) return;
    if (faces > kOneThread) return divide(part);
    part.nodes.reserve(faces / 14 + 2);
    part.blocks.reserve(faces / 3 + 2);
    if (faces <= shape_.block)
      add_block(part, part.range, kNoIndex, 0);
    else
      build_node(part, part.range);
    if (faces < kSmallRange) sorted_.record_done(faces);
  }

  uint32_t build_node(Part& part, const PrimitiveRange& range) {
    const auto n = static_cast<uint32_t>(part.nodes.size());
    make_empty(part.nodes.emplace_back());
    const Children c = open(range);
    const bool large = range.items.size() >= kSmallRange;
    for (uint32_t i = 0; i < c.count; ++i) {
      if (sorted_.stopped()) break;
      const size_t faces = c.range[i].items.size();
      const Child child = faces <= shape_.block ? Child::block(add_block(part, c.range[i], n, i))
                                                : Child::node(build_node(part, c.range[i]));
      if (!child.is_block()) {
        part.nodes[child.index()].parent = n;
        part.nodes[child.index()].slot = static_cast<uint8_t>(i);
      }
      part.nodes[n].child[i] = child;
      set_slot_box(part.nodes[n], i, c.range[i].bounds);
      if (large && faces < kSmallRange) sorted_.record_done(faces);
    }
    return n;
  }

  uint32_t add_block(Part& part, const PrimitiveRange& range, uint32_t parent, uint32_t slot) {
    assert(!range.items.empty() && range.items.size() <= kBlockWidth);
    part.blocks.push_back({static_cast<uint32_t>(range.items.data() - primitives_.data()),
                           static_cast<uint32_t>(range.items.size()), parent, slot});
    return static_cast<uint32_t>(part.blocks.size() - 1);
  }

  // Assigns consecutive records in the store to all parts, in depth-first order.
  void number(Part& part) {
    part.first_node = nodes_;
    part.first_block = blocks_;
    nodes_ += static_cast<uint32_t>(part.children.empty() ? part.nodes.size() : 1);
    blocks_ += static_cast<uint32_t>(part.blocks.size());
    for (uint32_t b = 0; b < part.blocks.size(); ++b) {
      if (part.blocks[b].count == 1) singles_.push_back(part.first_block + b);
    }
    if (part.children.empty()) whole_parts_.push_back({&part, kNoIndex, 0});
    for (uint32_t i = 0; i < part.children.size(); ++i) {
      number(part.children[i]);
      if (part.children[i].children.empty()) {
        whole_parts_.back().parent = part.first_node;
        whole_parts_.back().slot = i;
      }
    }
  }

  bool write(const Part& whole) {
    write_dividing_nodes(whole, kNoIndex, 0);
    return for_each_range(whole_parts_.size(), 1, &writing_,
                          [&](size_t i, size_t) { write(whole_parts_[i]); });
  }

  void write_dividing_nodes(const Part& part, uint32_t parent, uint32_t slot) {
    if (part.children.empty()) return;
    WideNode& node = store_.nodes.edit(part.first_node);
    make_empty(node);
    node.parent = parent;
    node.slot = static_cast<uint8_t>(slot);
    for (uint32_t i = 0; i < part.children.size(); ++i) {
      node.child[i] = part.children[i].child();
      set_slot_box(node, i, part.children[i].range.bounds);
      write_dividing_nodes(part.children[i], part.first_node, i);
    }
  }

  struct WholePart {
    const Part* part;
    uint32_t parent, slot;
  };

  void write(const WholePart& whole) {
    const Part& part = *whole.part;
    for (uint32_t n = 0; n < part.nodes.size(); ++n) {
      WideNode& node = store_.nodes.edit(part.first_node + n) = part.nodes[n];
      node.parent = n == 0 ? whole.parent : part.first_node + node.parent;
      if (n == 0) node.slot = static_cast<uint8_t>(whole.slot);
      for (Child& child : node.child) {
        if (!child.none()) child.bits += child.is_block() ? part.first_block : part.first_node;
      }
    }
    for (uint32_t b = 0; b < part.blocks.size(); ++b) {
      const PlannedBlock& block = part.blocks[b];
      const bool alone = block.parent == kNoIndex;
      put_block(part.first_block + b, alone ? whole.parent : part.first_node + block.parent,
                alone ? whole.slot : block.slot, block.count);
    }
    put_faces(part);
  }

  // Leaves the count of single-face blocks unset, because the store counts them (see run()).
  void put_block(uint32_t b, uint32_t node, uint32_t slot, uint32_t count) {
    FaceBlock& block = store_.blocks.edit(b);
    block.parent = node;
    block.slot = static_cast<uint8_t>(slot);
    block.count = static_cast<uint8_t>(count == 1 ? 0 : count);
  }

  void put_faces(const Part& part) {
    TriangleBatch batch;
    for (uint32_t first = 0, b = 0; first < part.blocks.size(); first = b) {
      batch.clear();
      for (; b < part.blocks.size() && batch.room() >= kBlockWidth; ++b) {
        for (const Primitive& p : faces_of(part.blocks[b])) batch.add(FaceId(p.number()));
      }
      batch.read(mesh_);
      for (uint32_t i = 0; first < b; ++first) {
        for (uint32_t lane = 0; lane < part.blocks[first].count; ++lane, ++i)
          store_.put(TreeFace(store_.frame, batch, i), part.first_block + first, lane);
      }
    }
  }
  std::span<const Primitive> faces_of(const PlannedBlock& block) const {
    return std::span(primitives_).subspan(block.first, block.count);
  }

  TreeStore& store_;
  const Mesh& mesh_;
  TreeShape shape_;
  Progress gathering_, sorting_, writing_;
  SortProgress sorted_;
  std::vector<Primitive> primitives_;   // numbered by face
  std::vector<WholePart> whole_parts_;  // in the order of their records
  std::vector<uint32_t> singles_;       // blocks of one face
  uint32_t nodes_ = 0, blocks_ = 0;     // numbered so far
};

}  // namespace

SortProgress::SortProgress(const Progress* progress, size_t faces)
    : progress_(progress), owner_(std::this_thread::get_id()), all_(need(faces)) {}

void SortProgress::record_split(size_t whole, size_t left, size_t right) {
  note(need(whole) - need(left) - need(right));
}
void SortProgress::record_done(size_t faces) { note(need(faces)); }

void SortProgress::note(double done) {
  constexpr double kReports = 100;  // at most
  const double sum = done_.fetch_add(done) + done;
  if (!progress_ || stopped_ || std::this_thread::get_id() != owner_ || sum < next_) return;
  if (!progress_->report(std::min(1.0, sum / all_))) stopped_ = true;
  next_ = sum + all_ / kReports;
}

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
  const Int4 bin = all_lanes(plane.bin);
  RangePair parts = partition(range, [&](const Primitive& p) {
    return (mask_bits(binning.bins_of(p) < bin) >> plane.axis & 1) != 0;
  });
  KERF_ASSERT(!parts.left.items.empty() && !parts.right.items.empty());
  return parts;
}

bool build_tree(TreeStore& store, const Mesh& mesh, const TreeFrame& frame, const Progress* progress,
                TreeShape shape) {
  KERF_ASSERT(store.root == kNoIndex && store.nodes.empty() && shape.block > 0 && shape.block <= kBlockWidth);
  store.frame = frame;
  store.reserve(mesh.live_faces(), mesh.face_slots());
  if (!TreeBuilder(store, mesh, shape, progress).run()) return false;
  store.nodes.touch_reserved();
  store.blocks.touch_reserved();
  return true;
}

}  // namespace kerf
