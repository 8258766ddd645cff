#include "core/tree/aabb_tree.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/base/random.h"
#include "core/mesh/measures.h"
#include "core/tree/build_tree.h"
#include "core/tree/tree_internal.h"

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
  tree.built_slots_ = mesh.face_slots();
  if (!bounds->is_none()) tree.set_bounds(*bounds);
  return tree;
}

void AabbTree::rebuild(const Mesh& mesh, TreeFrame frame) {
  const Bounds bounds = *bounds_of(mesh, nullptr);
  TreeShape shape;
  if (Shuffle::selected().on()) {
    Random random = Shuffle::selected().random(mesh.live_faces());
    shape = {static_cast<uint32_t>(1 + random.below(kBlockWidth)), random.below(2) == 0};
  }
  store_ = TreeStore();
  build_tree(store_, mesh, frame, nullptr, shape);
  leaf_count_ = mesh.live_faces();
  built_slots_ = mesh.face_slots();
  set_bounds(bounds.is_none() ? Bounds{} : bounds);
  loose_ = 0;
}

// Zeros of either sign become +0, so that the bounds do not depend on which corner they come from.
void AabbTree::set_bounds(const Bounds& bounds) { bounds_ = {bounds.min + Vec3(0), bounds.max + Vec3(0)}; }

void AabbTree::enlarge_bounds(const Vec3& corner) {
  Bounds larger = bounds_;
  larger.add(corner);
  set_bounds(larger);
}

void AabbTree::vary(const Mesh& mesh) {
  if (!Shuffle::selected().once_in(32)) return;
  rebuild(mesh, TreeFrame::around(*bounds_of(mesh, nullptr)));
}

void AabbTree::replace(const Mesh& mesh, std::span<const Replacement> all) {
  replace_faces(store_, mesh, all);
  for (const Replacement& r : all) leaf_count_ += size_t{r.added_count} - r.removed_count;
}

void AabbTree::remove(FaceId f) {
  KERF_ASSERT(leaf_count_ > 0);
  loosen_bounds(f);
  remove_face(store_, f);
  --leaf_count_;
}

void AabbTree::add(const Mesh& mesh, std::span<const FaceId> faces) {
  KERF_ASSERT(faces.empty() || leaf_count_ > 0);
  add_faces(store_, mesh, faces);
  for (const FaceId f : faces) {
    for (const Vec3& p : mesh.triangle(f)) enlarge_bounds(p);
  }
  leaf_count_ += faces.size();
}

void AabbTree::refit(const Mesh& mesh, std::span<const FaceId> faces) {
  for (const FaceId f : faces) {
    move_bounds(mesh, f);
    refit_face(store_, mesh, f);
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
    } else {
      move_bounds(mesh, f);  // its corners may have moved by less than floats resolve
    }
  }
  if (added.size() + moved.size() > leaf_count_ / 2) return rebuild(mesh, store_.frame);
  refit(mesh, moved);
  add(mesh, added);
  KERF_ASSERT(leaf_count_ == mesh.live_faces());
  fit_bounds(mesh);
}

// Boxes -----------------------------------------------------------------------------------------------------

AabbTree::Box AabbTree::box_of(const FloatBox& box, int depth, bool leaf, bool hit) const {
  const auto point = [&](Float4 p) { return store_.frame.to_mesh(Vec3(p[0], p[1], p[2])); };
  return {point(box.low), point(box.high), depth, leaf, hit};
}

namespace {

unsigned hit_lanes(const Mesh& mesh, const FaceBlock& block) {
  unsigned lanes = 0;
  for (uint32_t lane = 0; lane < block.count; ++lane)
    lanes |= unsigned{mesh.data(FaceId(block.face[lane])).hit} << lane;
  return lanes;
}

// Returns by node whether a face below it was hit.
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

// A side of the bounds: the minimum (sides 0 to 2) or the maximum (3 to 5) coordinate along an axis.
// Coordinates are negated for the minimum, so that every side seeks the largest value.
struct ExtremeSide {
  explicit ExtremeSide(unsigned side) : axis(static_cast<int>(side % 3)), plane(side), least(side < 3) {}

  double value(const Vec3& p) const { return least ? -p[axis] : p[axis]; }
  float value(float x) const { return least ? -x : x; }

  int axis;
  unsigned plane;  // in WideNode::plane
  bool least;
};

float coordinate(Float4 v, int axis) { return v[axis]; }

// A depth-first search for the largest value of a side, which skips a box if no corner in it can exceed the
// best one found. Rounding to floats is monotonic and boxes are rounded outward, so that a box whose float
// lies below that of a corner has only lesser corners.
class ExtremeSearch {
 public:
  ExtremeSearch(const TreeStore& tree, const Mesh& mesh, ExtremeSide side)
      : tree_(tree), mesh_(mesh), side_(side) {}

  // Returns the largest value; stops when it reaches `bound`. Preconditions: `start` is the value of a
  // corner, and no corner exceeds `bound`.
  double run(double bound, double start) {
    set_best(start);
    std::vector<Child> stack{Child::node(tree_.root)};
    while (!stack.empty() && best_ < bound) {
      const Child child = stack.back();
      stack.pop_back();
      if (child.is_block()) {
        open_block(tree_.blocks[child.index()]);
        continue;
      }
      const WideNode& node = tree_.nodes[child.index()];
      const size_t first = stack.size();
      for (uint32_t s = 0; s < kNodeWidth; ++s) {
        if (!node.child[s].none() && may_exceed(reach(node, s))) stack.push_back(node.child[s]);
      }
      // Opens the farthest-reaching child first.
      for (size_t i = first; i + 1 < stack.size(); ++i) {
        if (reach_of(stack[i]) > reach_of(stack.back())) std::swap(stack[i], stack.back());
      }
    }
    return best_;
  }

 private:
  float reach(const WideNode& node, uint32_t s) const { return side_.value(node.plane[side_.plane][s]); }
  float reach_of(Child child) const {
    const uint32_t i = child.index();
    return child.is_block() ? reach(tree_.nodes[tree_.blocks[i].parent], tree_.blocks[i].slot)
                            : reach(tree_.nodes[tree_.nodes[i].parent], tree_.nodes[i].slot);
  }
  bool may_exceed(float reach) const { return reach >= best_float_; }

  void open_block(const FaceBlock& block) {
    for (uint32_t l = 0; l < block.count; ++l) {
      for (int i = 0; i < 3; ++i) {
        if (!may_exceed(side_.value(block.corner[i][side_.axis][l]))) continue;
        const double value = side_.value(mesh_.position(VertexId(block.vertex[i][l])));
        if (value > best_) set_best(value);
      }
    }
  }

  void set_best(double value) {
    best_ = value;
    Vec3 p(0);
    p[side_.axis] = side_.least ? -value : value;
    best_float_ = side_.value(coordinate(tree_.frame.to_floats(p), side_.axis));
  }

  const TreeStore& tree_;
  const Mesh& mesh_;
  ExtremeSide side_;
  double best_ = 0;
  float best_float_ = 0;
};

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
      for (uint32_t lane = 0; lane < block.count; ++lane) {
        Box leaf =
            box_of(store_.face_box(block, lane), v.depth + (block.count > 1), true, (lanes >> lane & 1) != 0);
        leaf.edited = is_edited(mesh, FaceId(block.face[lane]));
        visit(leaf);
      }
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

std::vector<AabbTree::Box> AabbTree::path_to(const Mesh& mesh, FaceId f) const {
  std::vector<Box> path;
  const uint32_t place = store_.place(f);
  if (place == kNoIndex) return path;
  const FaceBlock& block = store_.blocks[place / kBlockWidth];
  const uint32_t lane = place % kBlockWidth;
  path.push_back(box_of(store_.face_box(block, lane), 0, true, mesh.data(f).hit));
  path.back().edited = is_edited(mesh, f);
  if (block.count > 1) path.push_back(box_of(store_.block_box(block), 0, false, false));
  for (uint32_t n = block.parent; n != kNoIndex; n = store_.nodes[n].parent) {
    const bool is_root = n == store_.root;
    path.push_back(box_of(is_root ? store_.root_box() : store_.node_box(store_.nodes[n]), 0, false, false));
    if (is_root) break;
  }
  std::reverse(path.begin(), path.end());
  for (size_t depth = 0; depth < path.size(); ++depth) path[depth].depth = static_cast<int>(depth);
  return path;
}

// A face reaches a side if its floats do: rounding may count too many, never too few.
void AabbTree::loosen_bounds(FaceId f) {
  const uint32_t place = store_.place(f);
  KERF_ASSERT(place != kNoIndex);
  const FaceBlock& block = store_.blocks[place / kBlockWidth];
  const uint32_t l = place % kBlockWidth;
  const Float4 low = store_.frame.to_floats(bounds_.min), high = store_.frame.to_floats(bounds_.max);
  for (int i = 0; i < 3; ++i) {
    const Float4 corner{block.corner[i][0][l], block.corner[i][1][l], block.corner[i][2][l], 0};
    loose_ |= (mask_bits(corner <= low) & 7) | (mask_bits(corner >= high) & 7) << 3;
  }
}

void AabbTree::move_bounds(const Mesh& mesh, FaceId f) {
  loosen_bounds(f);
  for (const Vec3& p : mesh.triangle(f)) enlarge_bounds(p);
}

void AabbTree::fit_bounds(const Mesh& mesh) {
  const unsigned loose = std::exchange(loose_, 0);
  if (loose == 0) return;
  if (store_.root == kNoIndex) return set_bounds({});
  const Vec3 start = mesh.position(VertexId(any_block().vertex[0][0]));
  Bounds fitted = bounds_;
  for (unsigned s = 0; s < 6; ++s) {
    if ((loose >> s & 1) == 0) continue;
    const ExtremeSide side(s);
    Vec3& own = side.least ? fitted.min : fitted.max;
    const double found = ExtremeSearch(store_, mesh, side).run(side.value(own), side.value(start));
    own[side.axis] = side.least ? -found : found;
  }
  set_bounds(fitted);
}

// Precondition: the tree is not empty.
const FaceBlock& AabbTree::any_block() const {
  KERF_ASSERT(store_.root != kNoIndex);
  Child child = Child::node(store_.root);
  while (!child.is_block()) {
    const auto& children = store_.nodes[child.index()].child;
    child = *std::find_if(std::begin(children), std::end(children), [](Child c) { return !c.none(); });
  }
  return store_.blocks[child.index()];
}

}  // namespace kerf
