#include "core/tree/build_tree.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/tree/binned_split.h"

namespace kerf {

namespace {

// About how many faces a block gets.
constexpr size_t kFacesABlock = 3;

class TreeBuilder {
 public:
  TreeBuilder(TreeStore& store, const Mesh& mesh) : store_(store) {
    faces_.reserve(mesh.live_faces());
    primitives_.reserve(mesh.live_faces());
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (mesh.is_live(FaceId(f))) gather(mesh, FaceId(f));
    }
  }

  void run() {
    if (faces_.empty()) return;
    PrimitiveRange all;
    all.items = primitives_;
    for (const Primitive& p : primitives_) all.add(p);
    store_.root = build_node(all);
    store_.set_root_box(store_.node_box(store_.nodes[store_.root]));
  }

 private:
  void gather(const Mesh& mesh, FaceId f) {
    const TreeFace face(store_.frame, mesh, f);
    primitives_.push_back(Primitive::make(face.box(), static_cast<uint32_t>(faces_.size())));
    faces_.push_back(face);
  }

  struct Children {
    std::array<PrimitiveRange, kNodeWidth> range;
    uint32_t count = 1;

    // The child of the largest area among those of so many faces, or null.
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

  // Splits the child of the largest area until the node is full or its children are small enough to be nodes
  // of blocks only. What room is left takes the blocks of such children, as far as all of one fit in: a node
  // of few blocks costs as much as a full one.
  static Children open(const PrimitiveRange& range) {
    Children c;
    c.range[0] = range;
    const size_t faces = range.items.size();
    const bool of_blocks = faces <= kNodeWidth * kBlockWidth;
    while (c.count < kNodeWidth) {
      PrimitiveRange* child = c.largest(of_blocks ? kBlockWidth : kNodeWidth * kBlockWidth, faces);
      if (!child) child = c.largest(kBlockWidth, (kNodeWidth - c.count + 1) * kFacesABlock);
      if (!child) break;
      c.split(child);
    }
    return c;
  }

  uint32_t build_node(const PrimitiveRange& range) {
    const uint32_t n = store_.add_node();
    const Children c = open(range);
    for (uint32_t i = 0; i < c.count; ++i) {
      const bool fits = c.range[i].items.size() <= kBlockWidth;
      const Child child = fits ? Child::block(build_block(c.range[i])) : Child::node(build_node(c.range[i]));
      store_.hang(n, i, child, c.range[i].bounds);
    }
    return n;
  }

  uint32_t build_block(const PrimitiveRange& range) {
    const uint32_t b = store_.add_block();
    uint32_t lane = 0;
    for (const Primitive& p : range.items) store_.put(faces_[p.number()], b, lane++);
    store_.set_count(b, lane);
    return b;
  }

  TreeStore& store_;
  std::vector<TreeFace> faces_;
  std::vector<Primitive> primitives_;
};

}  // namespace

void build_tree(TreeStore& store, const Mesh& mesh) {
  store.frame = TreeFrame::around(mesh);
  store.reserve(mesh.live_faces(), mesh.face_slots());
  TreeBuilder(store, mesh).run();
  store.nodes.touch_reserved();
  store.blocks.touch_reserved();
}

}  // namespace kerf
