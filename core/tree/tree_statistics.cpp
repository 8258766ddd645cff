#include "core/tree/tree_statistics.h"

#include "core/base/assert.h"

namespace kerf {

namespace {

using Box = AabbTree::Box;

// Half of the surface area of a box; 0 for an empty one.
double half_area(const Vec3& min, const Vec3& max) {
  const Vec3 size = max - min;
  if (size.x < 0 || size.y < 0 || size.z < 0) return 0;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

// Collects the boxes of a tree, which come depth first, parents before children.
class LevelSums {
 public:
  void add(const Box& box) {
    const auto depth = static_cast<size_t>(box.depth);
    KERF_ASSERT(depth <= levels_.size());
    if (depth == levels_.size()) levels_.emplace_back(), siblings_.emplace_back();
    for (size_t below = depth + 1; below < siblings_.size(); ++below) siblings_[below].clear();
    TreeLevel& level = levels_[depth];
    ++level.boxes;
    level.leaves += box.leaf;
    level.edited += box.edited;
    level.visits += half_area(box.min, box.max);
    for (const Box& other : siblings_[depth])
      level.overlap += half_area(glm::max(box.min, other.min), glm::min(box.max, other.max));
    siblings_[depth].push_back(box);
  }

  // Divides the sums by the area of the root; a line through a point meets every box.
  std::vector<TreeLevel> levels() {
    const double root = levels_.empty() ? 0 : levels_.front().visits;
    for (TreeLevel& level : levels_) {
      level.visits = root > 0 ? level.visits / root : static_cast<double>(level.boxes);
      level.overlap = root > 0 ? level.overlap / root : 0;
    }
    return levels_;
  }

 private:
  std::vector<TreeLevel> levels_;
  std::vector<std::vector<Box>> siblings_;  // by depth: earlier children of the current parent
};

template <typename T>
T sum_of(const std::vector<TreeLevel>& levels, T TreeLevel::*member) {
  T sum{};
  for (const TreeLevel& level : levels) sum += level.*member;
  return sum;
}

}  // namespace

double TreeStatistics::cost() const { return sum_of(levels, &TreeLevel::visits); }
double TreeStatistics::overlap() const { return sum_of(levels, &TreeLevel::overlap); }
size_t TreeStatistics::edited() const { return sum_of(levels, &TreeLevel::edited); }

void TreeStatistics::add(const TreeStatistics& other) {
  if (levels.size() < other.levels.size()) levels.resize(other.levels.size());
  for (size_t depth = 0; depth < other.levels.size(); ++depth) {
    TreeLevel& sum = levels[depth];
    const TreeLevel& own = other.levels[depth];
    sum.boxes += own.boxes;
    sum.leaves += own.leaves;
    sum.edited += own.edited;
    sum.visits += own.visits;
    sum.overlap += own.overlap;
  }
}

TreeStatistics tree_statistics(const AabbTree& tree, const Mesh& mesh) {
  LevelSums sums;
  tree.for_each_box(mesh, [&](const Box& box) { sums.add(box); });
  return {sums.levels()};
}

}  // namespace kerf
