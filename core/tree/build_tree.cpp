#include "core/tree/build_tree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/tree/binned_split.h"

namespace kerf {

namespace {

// Average number of faces in a block.
constexpr size_t kFacesABlock = 3;

// Ranges of at least this many faces report progress at each split, smaller ones when they are finished.
constexpr size_t kSmallRange = 4096;
constexpr double kFraming = 0.12, kGathering = 0.12;  // fractions of the time; the rest is sorting

// Progress of sorting. Sorting a range of n faces takes time in proportion to n log2 n, so a split accounts
// for the difference between the range and its two parts.
class SortProgress {
 public:
  SortProgress(const Progress* progress, size_t faces) : progress_(progress), all_(need(faces)) {}

  void note_split(size_t whole, size_t left, size_t right) { note(need(whole) - need(left) - need(right)); }
  void note_done(size_t faces) { note(need(faces)); }
  bool stopped() const { return stopped_; }

 private:
  static double need(size_t faces) {
    return faces < 2 ? 0 : static_cast<double>(faces) * std::log2(static_cast<double>(faces));
  }
  void note(double done) {
    done_ += done;
    if (!progress_ || stopped_ || done_ < next_) return;
    stopped_ = !progress_->report(std::min(1.0, done_ / all_));
    next_ = done_ + all_ / kReports;
  }

  static constexpr double kReports = 100;  // at most
  const Progress* progress_;
  double all_, done_ = 0, next_ = 0;
  bool stopped_ = false;
};

class TreeBuilder {
 public:
  TreeBuilder(TreeStore& store, const Mesh& mesh, const Progress* progress)
      : store_(store),
        gathering_(share_of(progress, kFraming, kFraming + kGathering)),
        sorting_(share_of(progress, kFraming + kGathering, 1)),
        sorted_(&sorting_, mesh.live_faces()) {}

  // Returns false if it was stopped.
  bool run(const Mesh& mesh) {
    if (!gather(mesh)) return false;
    if (faces_.empty()) return true;
    PrimitiveRange all;
    all.items = primitives_;
    for (const Primitive& p : primitives_) all.add(p);
    store_.root = build_node(all);
    store_.set_root_box(store_.node_box(store_.nodes[store_.root]));
    return !sorted_.stopped();
  }

 private:
  bool gather(const Mesh& mesh) {
    faces_.reserve(mesh.live_faces());
    primitives_.reserve(mesh.live_faces());
    Pace pace(&gathering_, mesh.face_slots());
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (mesh.is_live(FaceId(f))) gather(mesh, FaceId(f));
      if (!pace.step()) return false;
    }
    return true;
  }
  void gather(const Mesh& mesh, FaceId f) {
    const TreeFace face(store_.frame, mesh, f);
    primitives_.push_back(Primitive::make(face.box(), static_cast<uint32_t>(faces_.size())));
    faces_.push_back(face);
  }

  struct Children {
    std::array<PrimitiveRange, kNodeWidth> range;
    uint32_t count = 1;

    // The child of the largest area among those with more than `more_than` and at most `at_most` faces, or
    // null.
    PrimitiveRange* largest(size_t more_than, size_t at_most) {
      PrimitiveRange* best = nullptr;
      for (uint32_t i = 0; i < count; ++i) {
        const size_t faces = range[i].items.size();
        if (faces <= more_than || faces > at_most) continue;
        if (!best || range[i].bounds.area() > best->bounds.area()) best = &range[i];
      }
      return best;
    }
    void split(PrimitiveRange* child) {
      const RangePair parts = split_binned(*child, kBlockWidth);
      *child = parts.left;
      range[count++] = parts.right;
    }
  };

  // Splits the child of the largest area until the node is full or each child is small enough to be a node of
  // blocks only. The remaining slots take the blocks of such children directly where all blocks of a child
  // fit, because visiting a node with few blocks costs as much as visiting a full one.
  Children open(const PrimitiveRange& range) {
    Children c;
    c.range[0] = range;
    const size_t faces = range.items.size();
    const bool of_blocks = faces <= kNodeWidth * kBlockWidth;
    while (c.count < kNodeWidth) {
      PrimitiveRange* child = c.largest(of_blocks ? kBlockWidth : kNodeWidth * kBlockWidth, faces);
      if (!child) child = c.largest(kBlockWidth, (kNodeWidth - c.count + 1) * kFacesABlock);
      if (!child || sorted_.stopped()) break;
      if (faces < kSmallRange)
        c.split(child);
      else
        split(c, child);
    }
    return c;
  }

  void split(Children& c, PrimitiveRange* child) {
    const size_t whole = child->items.size();
    c.split(child);
    const size_t left = child->items.size();
    sorted_.note_split(whole, left, whole - left);
  }

  uint32_t build_node(const PrimitiveRange& range) {
    const uint32_t n = store_.add_node();
    const Children c = open(range);
    const bool large = range.items.size() >= kSmallRange;
    for (uint32_t i = 0; i < c.count; ++i) {
      if (sorted_.stopped()) break;
      const size_t faces = c.range[i].items.size();
      const bool fits = faces <= kBlockWidth;
      const Child child = fits ? Child::block(build_block(c.range[i])) : Child::node(build_node(c.range[i]));
      store_.hang(n, i, child, c.range[i].bounds);
      if (large && faces < kSmallRange) sorted_.note_done(faces);
    }
    return n;
  }

  uint32_t build_block(const PrimitiveRange& range) {
    assert(!range.items.empty() && range.items.size() <= kBlockWidth);
    const uint32_t b = store_.add_block();
    uint32_t lane = 0;
    for (const Primitive& p : range.items) store_.put(faces_[p.number()], b, lane++);
    store_.set_count(b, lane);
    return b;
  }

  TreeStore& store_;
  Progress gathering_, sorting_;
  SortProgress sorted_;
  std::vector<TreeFace> faces_;
  std::vector<Primitive> primitives_;
};

}  // namespace

bool build_tree(TreeStore& store, const Mesh& mesh, const Progress* progress) {
  assert(store.root == kNoIndex && store.nodes.empty());
  const Progress framing = share_of(progress, 0, kFraming);
  const Result<TreeFrame> frame = TreeFrame::around(mesh, &framing);
  if (!frame) return false;
  store.frame = *frame;
  store.reserve(mesh.live_faces(), mesh.face_slots());
  if (!TreeBuilder(store, mesh, progress).run(mesh)) return false;
  store.nodes.touch_reserved();
  store.blocks.touch_reserved();
  return true;
}

}  // namespace kerf
