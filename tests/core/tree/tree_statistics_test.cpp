#include "core/tree/tree_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/refinement.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// Returns true if a line meets a box.
bool meets(const Pose& line, const Vec3& min, const Vec3& max) {
  double from = -1e9, to = 1e9;
  for (int k = 0; k < 3; ++k) {
    const double a = (min[k] - line.origin[k]) / line.direction[k];
    const double b = (max[k] - line.origin[k]) / line.direction[k];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to;
}

std::vector<AabbTree::Box> boxes_of(const AabbTree& tree, const Mesh& mesh) {
  std::vector<AabbTree::Box> boxes;
  tree.for_each_box(mesh, [&](const AabbTree::Box& box) { boxes.push_back(box); });
  return boxes;
}

// A line of uniform direction through a uniform point of the disc across it, around a sphere of this radius.
Pose random_line(Random& random, double radius) {
  const Vec3 direction = random_direction(random);
  for (;;) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    const Vec3 in_ball(x, y, z);
    const Vec3 across = in_ball - glm::dot(in_ball, direction) * direction;
    if (glm::length(in_ball) < 0.05 || glm::length(across) > 1) continue;
    const Vec3 side = glm::normalize(across);
    return {radius * std::sqrt(random.unit()) * side, direction};
  }
}

TEST(TreeStatistics, cost_is_the_mean_number_of_boxes_that_random_lines_meet) {
  const Mesh mesh = build(sphere(12, 16, 1)).mesh;
  const AabbTree tree(mesh);
  const std::vector<AabbTree::Box> boxes = boxes_of(tree, mesh);
  const TreeStatistics statistics = tree_statistics(tree, mesh);
  Random random(7);
  size_t lines = 0, met = 0;
  while (lines < 20'000) {
    const Pose line = random_line(random, 1.8);
    if (!meets(line, boxes.front().min, boxes.front().max)) continue;
    ++lines;
    met += static_cast<size_t>(
        std::ranges::count_if(boxes, [&](const AabbTree::Box& b) { return meets(line, b.min, b.max); }));
  }
  EXPECT_NEAR(static_cast<double>(met) / static_cast<double>(lines), statistics.cost(),
              0.02 * statistics.cost());
  EXPECT_EQ(statistics.levels.front().visits, 1);
  EXPECT_GT(statistics.overlap(), 0);
  EXPECT_LT(statistics.overlap(), statistics.cost());
}

TEST(TreeStatistics, overlap_is_the_relative_area_of_the_intersections_of_siblings) {
  const Mesh mesh = build(sphere(12, 16, 1)).mesh;
  const AabbTree tree(mesh);
  const std::vector<AabbTree::Box> boxes = boxes_of(tree, mesh);
  const auto half_area = [](const Vec3& size) { return size.x * size.y + size.y * size.z + size.z * size.x; };
  double sum = 0;
  for (size_t i = 0; i < boxes.size(); ++i) {
    // Earlier boxes of the same depth, back to the parent.
    for (size_t j = i; j-- > 0 && boxes[j].depth >= boxes[i].depth;) {
      if (boxes[j].depth > boxes[i].depth) continue;
      const Vec3 shared = glm::min(boxes[i].max, boxes[j].max) - glm::max(boxes[i].min, boxes[j].min);
      if (std::min({shared.x, shared.y, shared.z}) >= 0) sum += half_area(shared);
    }
  }
  const double expected = sum / half_area(boxes.front().max - boxes.front().min);
  EXPECT_GT(expected, 0);
  EXPECT_NEAR(tree_statistics(tree, mesh).overlap(), expected, 1e-9 * expected);
}

TEST(TreeStatistics, count_every_box_and_the_faces_that_splits_made) {
  BuiltMesh built = build(grid(8, 1));
  Mesh& mesh = built.mesh;
  AabbTree tree(mesh);
  EXPECT_EQ(tree_statistics(tree, mesh).edited(), 0u);
  OneToFour refinement;
  std::vector<Replacement> replaced;
  refinement.split(mesh, FaceId(9), replaced);
  tree.replace(mesh, replaced);
  size_t split = 0;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f)
    split += mesh.is_live(FaceId(f)) && mesh.data(FaceId(f)).halvings > 0;
  const TreeStatistics statistics = tree_statistics(tree, mesh);
  size_t boxes = 0, leaves = 0;
  for (const TreeLevel& level : statistics.levels) boxes += level.boxes, leaves += level.leaves;
  EXPECT_EQ(boxes, tree.box_count());
  EXPECT_EQ(leaves, tree.leaf_count());
  EXPECT_GT(split, 3u);
  EXPECT_EQ(statistics.edited(), split);
  TreeStatistics twice = statistics;
  twice.add(statistics);
  EXPECT_EQ(twice.cost(), 2 * statistics.cost());
  EXPECT_EQ(twice.edited(), 2 * split);
}

TEST(PathTo, leads_from_the_root_to_the_box_of_the_face) {
  const Mesh mesh = build(sphere(10, 12, 1)).mesh;
  AabbTree tree(mesh);
  const std::vector<AabbTree::Box> boxes = boxes_of(tree, mesh);
  const auto is_box = [&](const AabbTree::Box& own) {
    return std::ranges::any_of(boxes, [&](const AabbTree::Box& b) {
      return b.min == own.min && b.max == own.max && b.depth == own.depth && b.leaf == own.leaf;
    });
  };
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    const std::vector<AabbTree::Box> path = tree.path_to(mesh, FaceId(f));
    ASSERT_GE(path.size(), 2u);
    EXPECT_TRUE(std::ranges::all_of(path, is_box));
    EXPECT_TRUE(path.back().leaf);
    for (const Vec3& corner : mesh.triangle(FaceId(f)))
      EXPECT_TRUE(glm::min(corner, path.back().min) == path.back().min &&
                  glm::max(corner, path.back().max) == path.back().max);
    for (size_t i = 1; i < path.size(); ++i)
      EXPECT_TRUE(glm::min(path[i].min, path[i - 1].min) == path[i - 1].min &&
                  glm::max(path[i].max, path[i - 1].max) == path[i - 1].max);
  }
  tree.remove(FaceId(3));
  EXPECT_TRUE(tree.path_to(mesh, FaceId(3)).empty());
}

TEST(PathTo, begins_at_the_root_after_its_only_child_replaced_it) {
  const Mesh mesh = build(sphere(10, 12, 1)).mesh;
  AabbTree tree(mesh);
  FaceId deepest(0);
  for (uint32_t f = 1; f < mesh.face_slots(); ++f) {
    if (tree.path_to(mesh, FaceId(f)).size() > tree.path_to(mesh, deepest).size()) deepest = FaceId(f);
  }
  const std::vector<AabbTree::Box> before = tree.path_to(mesh, deepest);
  ASSERT_GE(before.size(), 4u) << "the root, a node, a block and the face";
  std::vector<FaceId> elsewhere;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    const AabbTree::Box below_root = tree.path_to(mesh, FaceId(f))[1];
    if (below_root.min != before[1].min || below_root.max != before[1].max) elsewhere.emplace_back(f);
  }
  for (const FaceId f : elsewhere) tree.remove(f);
  const std::vector<AabbTree::Box> after = tree.path_to(mesh, deepest);
  ASSERT_EQ(after.size(), before.size() - 1);
  for (size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].min, before[i + 1].min) << i;
    EXPECT_EQ(after[i].max, before[i + 1].max) << i;
    EXPECT_EQ(after[i].depth, static_cast<int>(i));
  }
}

}  // namespace
}  // namespace kerf::test
