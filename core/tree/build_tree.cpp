#include "core/tree/build_tree.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/tree/binned_split.h"

namespace kerf {

namespace {

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

  // Splits the child of the largest area until the node is full or its children are blocks.
  struct Children {
    std::array<PrimitiveRange, kNodeWidth> range;
    uint32_t count = 1;
  };
  static Children open(const PrimitiveRange& range) {
    Children c;
    c.range[0] = range;
    while (c.count < kNodeWidth) {
      PrimitiveRange* largest = nullptr;
      float area = -1;
      for (uint32_t i = 0; i < c.count; ++i) {
        if (c.range[i].items.size() <= kBlockWidth || c.range[i].bounds.area() <= area) continue;
        largest = &c.range[i];
        area = largest->bounds.area();
      }
      if (!largest) break;
      const RangePair parts = split_binned(*largest, kBlockWidth);
      *largest = parts.left;
      c.range[c.count++] = parts.right;
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
}

}  // namespace kerf
