#include "core/tree/aabb_tree.h"

#include "core/base/assert.h"
#include "core/tree/build_tree.h"
#include "core/tree/edit_tree.h"

namespace kerf {

AabbTree::AabbTree(const Mesh& mesh, Simd simd) : leaf_count_(mesh.live_faces()), walks_(&walks_for(simd)) {
  build_tree(store_, mesh, nullptr);
}

Result<AabbTree> AabbTree::build(const Mesh& mesh, const Progress* progress) {
  AabbTree tree;
  tree.leaf_count_ = mesh.live_faces();
  if (!build_tree(tree.store_, mesh, progress)) return cancelled();
  return tree;
}

void AabbTree::replace(const Mesh& mesh, std::span<const FaceId> gone, std::span<const FaceId> born) {
  KERF_ASSERT(!gone.empty() && !born.empty());
  replace_faces(store_, mesh, gone, born);
  leaf_count_ += born.size() - gone.size();
}

void AabbTree::replace(const Mesh& mesh, std::span<const Replacement> all) {
  replace_faces(store_, mesh, all);
  for (const Replacement& r : all) leaf_count_ += size_t{r.born_count} - r.gone_count;
}

void AabbTree::remove(FaceId f) {
  KERF_ASSERT(leaf_count_ > 0);
  remove_face(store_, f);
  --leaf_count_;
}

void AabbTree::add(const Mesh& mesh, std::span<const FaceId> faces) {
  for (const FaceId f : faces) add_face(store_, mesh, f);
  leaf_count_ += faces.size();
}

void AabbTree::refit(const Mesh& mesh, std::span<const FaceId> faces) {
  for (const FaceId f : faces) refit_face(store_, mesh, f);
}

// Boxes -----------------------------------------------------------------------------------------------------

AabbTree::Box AabbTree::box_of(const FloatBox& box, int depth, bool leaf, bool hit) const {
  const auto point = [&](__m128 p) {
    alignas(16) float xyz[4];
    _mm_store_ps(xyz, p);
    return store_.frame.to_mesh(Vec3(xyz[0], xyz[1], xyz[2]));
  };
  return {point(box.low), point(box.high), depth, leaf, hit};
}

AabbTree::Box AabbTree::bounds() const {
  return store_.root == kNoIndex ? Box{} : box_of(store_.root_box(), 0, false, store_.root_hit);
}

size_t AabbTree::box_count() const {
  return store_.node_count() + store_.block_count() + leaf_count_ - store_.single_count();
}

void AabbTree::for_each_box(const std::function<void(const Box&)>& visit) const {
  if (store_.root == kNoIndex) return;
  struct Visit {
    Child child;
    FloatBox box;
    int depth;
    bool hit;
  };
  std::vector<Visit> stack{{Child::node(store_.root), store_.root_box(), 0, store_.root_hit}};
  while (!stack.empty()) {
    const Visit v = stack.back();
    stack.pop_back();
    if (v.child.is_block()) {
      const FaceBlock& block = store_.blocks[v.child.index()];
      if (block.count > 1) visit(box_of(v.box, v.depth, false, v.hit));
      for (uint32_t lane = 0; lane < block.count; ++lane)
        visit(box_of(store_.face_box(block, lane), v.depth + (block.count > 1), true,
                     (block.hit >> lane & 1) != 0));
      continue;
    }
    visit(box_of(v.box, v.depth, false, v.hit));
    const WideNode& node = store_.nodes[v.child.index()];
    for (uint32_t s = kNodeWidth; s-- > 0;) {
      if (node.child[s].none()) continue;
      stack.push_back(
          {node.child[s], store_.slot_box(v.child.index(), s), v.depth + 1, (node.hit >> s & 1) != 0});
    }
  }
}

}  // namespace kerf
