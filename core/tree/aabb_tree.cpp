#include "core/tree/aabb_tree.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/shuffle.h"
#include "core/mesh/mesh_bounds.h"
#include "core/tree/build_tree.h"
#include "core/tree/edit_tree.h"

namespace kerf {

AabbTree::AabbTree(const Mesh& mesh, Simd simd) : walks_(&walks_for(simd)) {
  rebuild(mesh, TreeFrame::around(*bounds_of(mesh, nullptr)));
}

Result<AabbTree> AabbTree::build(const Mesh& mesh, const Progress* progress) {
  constexpr double kBounding = 0.02;  // of the time
  const Progress bounding = share_of(progress, 0, kBounding), building = share_of(progress, kBounding, 1);
  const Result<Bounds> bounds = bounds_of(mesh, &bounding);
  AabbTree tree;
  if (!bounds || !build_tree(tree.store_, mesh, TreeFrame::around(*bounds), &building)) return cancelled();
  tree.leaf_count_ = mesh.live_faces();
  if (!bounds->is_none()) tree.set_bounds(*bounds);
  return tree;
}

void AabbTree::rebuild(const Mesh& mesh, TreeFrame frame) {
  const Bounds bounds = *bounds_of(mesh, nullptr);
  TreeShape shape;
  if (Shuffle::chosen().on()) {
    Random random = Shuffle::chosen().random(mesh.live_faces());
    shape = {static_cast<uint32_t>(1 + random.below(kBlockWidth)), random.below(2) == 0};
  }
  store_ = TreeStore();
  build_tree(store_, mesh, frame, nullptr, shape);
  leaf_count_ = mesh.live_faces();
  set_bounds(bounds.is_none() ? Bounds{} : bounds);
  loose_ = 0;
}

// A zero of either sign becomes +0, so that the bounds do not show from which corner they come.
void AabbTree::set_bounds(const Bounds& bounds) { bounds_ = {bounds.min + Vec3(0), bounds.max + Vec3(0)}; }

void AabbTree::enlarge_bounds(const Vec3& corner) {
  Bounds larger = bounds_;
  larger.add(corner);
  set_bounds(larger);
}

void AabbTree::vary(const Mesh& mesh) {
  if (!Shuffle::chosen().once_in(32)) return;
  rebuild(mesh, TreeFrame::around(*bounds_of(mesh, nullptr)));
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
  loosen_bounds(f);
  remove_face(store_, f);
  --leaf_count_;
}

void AabbTree::add(const Mesh& mesh, std::span<const FaceId> faces) {
  for (const FaceId f : faces) {
    add_face(store_, mesh, f);
    for (const Vec3& p : mesh.triangle(f)) enlarge_bounds(p);
  }
  leaf_count_ += faces.size();
}

void AabbTree::refit(const Mesh& mesh, std::span<const FaceId> faces) {
  for (const FaceId f : faces) {
    loosen_bounds(f);
    refit_face(store_, mesh, f);
    for (const Vec3& p : mesh.triangle(f)) enlarge_bounds(p);
  }
}

void AabbTree::update(const Mesh& mesh, std::vector<FaceId> faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::vector<FaceId> added, moved;
  for (const FaceId f : faces) {
    const uint32_t place = store_.place(f);
    const bool live = mesh.is_live(f);
    if (place == kNoIndex) {
      if (live) added.push_back(f);
    } else if (!live) {
      remove(f);
    } else if (!store_.holds(TreeFace(store_.frame, mesh, f), place / kBlockWidth, place % kBlockWidth)) {
      moved.push_back(f);
    }
  }
  if (added.size() + moved.size() > leaf_count_ / 2) return rebuild(mesh, store_.frame);
  refit(mesh, moved);
  add(mesh, added);
  fit_bounds(mesh);
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

namespace {

unsigned hit_lanes(const Mesh& mesh, const FaceBlock& block) {
  unsigned lanes = 0;
  for (uint32_t lane = 0; lane < block.count; ++lane)
    lanes |= unsigned{mesh.data(FaceId(block.face[lane])).hit} << lane;
  return lanes;
}

// For each node whether a face below it was hit.
std::vector<bool> hit_nodes(const TreeStore& tree, const Mesh& mesh) {
  std::vector<bool> hit(tree.nodes.size());
  std::vector<uint32_t> order{tree.root};  // parents before children
  for (size_t i = 0; i < order.size(); ++i) {
    for (const Child child : tree.nodes[order[i]].child) {
      if (child.none()) continue;
      if (!child.is_block())
        order.push_back(child.index());
      else if (hit_lanes(mesh, tree.blocks[child.index()]) != 0)
        hit[order[i]] = true;
    }
  }
  for (size_t i = order.size(); i-- > 1;) {
    if (hit[order[i]]) hit[tree.nodes[order[i]].parent] = true;
  }
  return hit;
}

}  // namespace

size_t AabbTree::box_count() const {
  return store_.node_count() + store_.block_count() + leaf_count_ - store_.single_count();
}

void AabbTree::for_each_box(const Mesh& mesh, const std::function<void(const Box&)>& visit) const {
  if (store_.root == kNoIndex) return;
  struct Visit {
    Child child;
    FloatBox box;
    int depth;
  };
  const std::vector<bool> hit = hit_nodes(store_, mesh);
  std::vector<Visit> stack{{Child::node(store_.root), store_.root_box(), 0}};
  while (!stack.empty()) {
    const Visit v = stack.back();
    stack.pop_back();
    if (v.child.is_block()) {
      const FaceBlock& block = store_.blocks[v.child.index()];
      const unsigned lanes = hit_lanes(mesh, block);
      if (block.count > 1) visit(box_of(v.box, v.depth, false, lanes != 0));
      for (uint32_t lane = 0; lane < block.count; ++lane)
        visit(box_of(store_.face_box(block, lane), v.depth + (block.count > 1), true,
                     (lanes >> lane & 1) != 0));
      continue;
    }
    visit(box_of(v.box, v.depth, false, hit[v.child.index()]));
    const WideNode& node = store_.nodes[v.child.index()];
    for (uint32_t s = kNodeWidth; s-- > 0;) {
      if (node.child[s].none()) continue;
      stack.push_back({node.child[s], store_.slot_box(v.child.index(), s), v.depth + 1});
    }
  }
}

}  // namespace kerf
