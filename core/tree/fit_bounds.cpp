#include <algorithm>
#include <utility>
#include <vector>

#include "core/tree/aabb_tree.h"

namespace kerf {

namespace {

// A side of the bounds: the least (sides 0 to 2) or the largest (3 to 5) coordinate along an axis.
// Coordinates are negated where the least is sought, so that the largest value is sought on every side.
struct ExtremeSide {
  explicit ExtremeSide(unsigned side) : axis(static_cast<int>(side % 3)), plane(side), least(side < 3) {}

  double value(const Vec3& p) const { return least ? -p[axis] : p[axis]; }
  float value(float x) const { return least ? -x : x; }

  int axis;
  unsigned plane;  // in WideNode::plane
  bool least;
};

float coordinate(__m128 v, int axis) {
  alignas(16) float xyz[4];
  _mm_store_ps(xyz, v);
  return xyz[axis];
}

// The search for the largest value of a side: depth first, a box being passed over if no corner in it can
// exceed the best one found. Rounding to floats is monotonic and boxes are rounded outward, so that a box
// whose float lies below that of a corner has only lesser corners.
class ExtremeSearch {
 public:
  ExtremeSearch(const TreeStore& tree, const Mesh& mesh, ExtremeSide side)
      : tree_(tree), mesh_(mesh), side_(side) {}

  // Returns the largest value. Preconditions: `start` is that of a corner, and no corner exceeds `bound`, at
  // which the search ends.
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
      // The one that reaches farthest is opened first.
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

// A face reaches a side if its floats do: rounding may count too many, never too few.
void AabbTree::loosen_bounds(FaceId f) {
  const uint32_t place = store_.place(f);
  const FaceBlock& block = store_.blocks[place / kBlockWidth];
  const uint32_t l = place % kBlockWidth;
  const __m128 low = store_.frame.to_floats(bounds_.min), high = store_.frame.to_floats(bounds_.max);
  for (int i = 0; i < 3; ++i) {
    const __m128 corner = _mm_setr_ps(block.corner[i][0][l], block.corner[i][1][l], block.corner[i][2][l], 0);
    loose_ |= static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(corner, low)) & 7) |
              static_cast<unsigned>(_mm_movemask_ps(_mm_cmpge_ps(corner, high)) & 7) << 3;
  }
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
  Child child = Child::node(store_.root);
  while (!child.is_block()) {
    const auto& children = store_.nodes[child.index()].child;
    child = *std::find_if(std::begin(children), std::end(children), [](Child c) { return !c.none(); });
  }
  return store_.blocks[child.index()];
}

}  // namespace kerf
