#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/refinement.h"
#include "core/tree/aabb_tree.h"
#include "core/tree/tree_internal.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// Every box with the boxes below it, from for_each_box's order, and their number.
void expect_boxes_nest(const AabbTree& tree, const Mesh& mesh) {
  std::vector<AabbTree::Box> above;
  size_t boxes = 0;
  tree.for_each_box(mesh, [&](const AabbTree::Box& box) {
    ++boxes;
    above.resize(static_cast<size_t>(box.depth));
    if (!above.empty()) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_LE(above.back().min[k], box.min[k]);
        EXPECT_GE(above.back().max[k], box.max[k]);
      }
    }
    above.push_back(box);
  });
  EXPECT_EQ(boxes, tree.box_count());
}

std::vector<RayHit> brute_crossings(const Mesh& mesh, const Pose& ray, Interval range) {
  const ShearedRay sheared(ray);
  std::vector<RayHit> hits;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    const auto length = sheared.cross(mesh.triangle(FaceId(f)));
    if (length && *length >= range.low && *length <= range.high) hits.push_back({FaceId(f), *length});
  }
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
    return a.length != b.length ? a.length < b.length : a.face < b.face;
  });
  return hits;
}

// The instruction sets of this processor, the best one last.
std::vector<Simd> supported() {
  std::vector<Simd> all;
  for (const Simd simd : {Simd::kPlain, Simd::kSse4, Simd::kAvx2}) {
    if (is_supported(simd)) all.push_back(simd);
  }
  return all;
}

// A mesh with a tree for each instruction set, edited alike.
struct Edited {
  explicit Edited(const Soup& soup) : mesh(build(soup).mesh) {
    for (const Simd simd : supported()) trees.emplace_back(mesh, simd);
    const Bounds all = best().bounds();
    centre = all.centre();
    size = all.diagonal();
  }

  void split(FaceId f) { refinement.split(mesh, f, late); }
  void bisect(FaceId f) { bisect_longest_edge(mesh, refinement, f, late); }
  void update_trees() {
    // The best tree is updated in one call, the others face by face.
    for (size_t i = 0; i + 1 < trees.size(); ++i) {
      for (const auto& r : late) trees[i].replace(mesh, {&r, 1});
    }
    best().replace(mesh, late);
    late.clear();
  }
  void remove(FaceId f) {
    const auto element = refinement.element(mesh, f);
    refinement.forget(mesh, f);
    for (int k = 0; k < element.face_count; ++k) {
      for (AabbTree& tree : trees) tree.remove(element.faces[k]);
      mesh.remove_face(element.faces[k]);
    }
  }
  // Adds triangles or tetrahedra that hang together with nothing.
  void add(int count, Random& random) {
    std::vector<std::array<VertexId, 3>> corners;
    for (int i = 0; i < count; ++i) {
      const Vec3 at = centre + random.uniform(0, 1.5) * size * random_direction(random);
      std::array<VertexId, 4> v;
      for (VertexId& corner : v)
        corner = mesh.add_vertex(at + random.uniform(1e-4, 0.3) * size * random_direction(random));
      corners.push_back({v[0], v[1], v[2]});
      if (random.below(2) == 0) continue;
      for (const std::array<VertexId, 3>& c :
           {std::array{v[1], v[0], v[3]}, {v[2], v[1], v[3]}, {v[0], v[2], v[3]}})
        corners.push_back(c);
    }
    const std::vector<FaceId> added = mesh.add_faces(corners, std::vector<FaceData>(corners.size()));
    for (AabbTree& tree : trees) tree.add(mesh, added);
  }

  AabbTree& best() { return trees.back(); }
  const AabbTree& best() const { return trees.back(); }

  Mesh mesh;
  OneToFour refinement;
  std::vector<AabbTree> trees;  // by instruction set, see supported()
  std::vector<Replacement> late;
  Vec3 centre;
  double size;
};

// The bounds of the corners of all faces.
Bounds brute_bounds(const Mesh& mesh) {
  Bounds bounds = Bounds::none();
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    for (const Vec3& p : mesh.triangle(FaceId(f))) bounds.add(p);
  }
  return bounds.is_none() ? Bounds{} : bounds;
}

void expect_answers_as_brute_force(Edited& e, Random& random) {
  for (AabbTree& tree : e.trees) {
    tree.fit_bounds(e.mesh);
    ASSERT_EQ(tree.bounds(), brute_bounds(e.mesh));
  }
  const Interval range{0.1 * e.size, 1.8 * e.size};
  for (int i = 0; i < 8; ++i) {
    const Vec3 axis = random_direction(random), sideways = random_direction(random);
    std::vector<Pose> rays;
    for (int r = 0; r < 1 + i % 4; ++r) {
      const Vec3 at = e.centre + 0.2 * e.size * random_direction(random) + 0.01 * r * e.size * sideways;
      // Outside of the mesh, or anywhere.
      rays.push_back({at - (i < 4 ? 1.0 : random.uniform(-0.3, 1)) * e.size * axis, axis});
    }
    std::vector<std::vector<RayHit>> brute_hits;
    for (const Pose& ray : rays) brute_hits.push_back(brute_crossings(e.mesh, ray, range));
    for (const AabbTree& tree : e.trees) {
      std::vector<std::vector<RayHit>> one(rays.size()), many(rays.size());
      tree.crossings(e.mesh, rays, range, many);
      ASSERT_EQ(many, brute_hits);
      for (size_t r = 0; r < rays.size(); ++r) {
        const std::vector<RayHit>& brute = brute_hits[r];
        tree.crossings(e.mesh, rays[r], range, one[r]);
        ASSERT_EQ(one[r], brute);
        ASSERT_EQ(tree.nearest(e.mesh, rays[r], range),
                  brute.empty() ? std::nullopt : std::optional(brute.front()));
      }
    }
    const SweptCylinder beam(rays[0], {rays[0].origin + 0.2 * e.size * sideways, axis}, 0.03 * e.size, range);
    std::vector<FaceId> brute;
    for (uint32_t f = 0; f < e.mesh.face_slots(); ++f) {
      if (e.mesh.is_live(FaceId(f)) && beam.touches(e.mesh.triangle(FaceId(f)))) brute.emplace_back(f);
    }
    QueryCounts first;
    for (const AabbTree& tree : e.trees) {
      std::vector<FaceId> found;
      const QueryCounts counts = tree.touched(e.mesh, beam, found);
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, brute);
      // Culling is the same to the bit as well, but the trees differ in shape by how they were updated.
      if (&tree == &e.trees[0]) first = counts;
      if (&tree + 1 != e.trees.data() + e.trees.size()) ASSERT_EQ(counts.faces, first.faces);
    }
  }
}

// Splits are told late, several at a time and one within another, among removals.
TEST(TreeEdits, all_queries_equal_brute_force_after_random_edits) {
  for (const uint64_t seed : {61u, 62u, 63u}) {
    for (const auto& [name, soup] : mesh_classes()) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Edited e(soup);
      Random random(seed);
      for (int round = 0; round < 8 && e.mesh.live_faces() > 0; ++round) {
        for (int i = 0; i < 12; ++i) {
          const FaceId f(static_cast<uint32_t>(random.below(e.mesh.face_slots())));
          if (!e.mesh.is_live(f)) continue;
          if (random.below(4) > 0 && e.mesh.data(f).halvings < 18 && e.refinement.can_split(e.mesh, f)) {
            random.below(2) > 0 ? e.split(f) : e.bisect(f);
          } else {
            e.update_trees();
            e.remove(f);
          }
        }
        e.update_trees();
        ASSERT_EQ(e.best().leaf_count(), e.mesh.live_faces());
        expect_boxes_nest(e.best(), e.mesh);
        ASSERT_NO_FATAL_FAILURE(expect_answers_as_brute_force(e, random));
      }
    }
  }
}

// Splits, removals and additions, some of them far from what was there.
void edit_at_random(Edited& e, Random& random) {
  for (int i = 0; i < 12; ++i) {
    const FaceId f(static_cast<uint32_t>(random.below(e.mesh.face_slots())));
    const uint64_t what = random.below(6);
    if (what == 0) {
      e.update_trees();
      if (e.mesh.live_faces() > 0) e.add(1 + static_cast<int>(random.below(12)), random);
    } else if (e.mesh.is_live(f) && what == 1) {
      e.update_trees();
      e.remove(f);
    } else if (e.mesh.is_live(f) && e.mesh.data(f).halvings < 18 && e.refinement.can_split(e.mesh, f)) {
      random.below(2) > 0 ? e.split(f) : e.bisect(f);
    }
  }
  e.update_trees();
}

TEST(TreeEdits, all_queries_equal_brute_force_with_added_faces) {
  for (const uint64_t seed : {64u, 65u, 66u}) {
    for (const auto& [name, soup] : mesh_classes()) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Edited e(soup);
      Random random(seed);
      for (int round = 0; round < 8 && e.mesh.live_faces() > 0; ++round) {
        edit_at_random(e, random);
        ASSERT_EQ(e.best().leaf_count(), e.mesh.live_faces());
        expect_boxes_nest(e.best(), e.mesh);
        ASSERT_NO_FATAL_FAILURE(expect_answers_as_brute_force(e, random));
      }
    }
  }
}

// More faces than one thread sorts.
TEST(TreeEdits, all_queries_equal_brute_force_in_a_large_mesh) {
  Edited e(torus(160, 120, 1, 0.4));
  Random random(67);
  for (int round = 0; round < 2; ++round) {
    ASSERT_EQ(e.best().leaf_count(), e.mesh.live_faces());
    expect_boxes_nest(e.best(), e.mesh);
    ASSERT_NO_FATAL_FAILURE(expect_answers_as_brute_force(e, random));
    edit_at_random(e, random);
  }
}

TEST(TreeEdits, all_queries_equal_brute_force_after_undo_and_redo) {
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Edited e(seed % 2 == 0 ? sphere(9, 14, 0.5) : grid(6, 1));
    for (int round = 0; round < 3; ++round) {
      Mesh::Change change;
      change.begin(e.mesh);
      const OneToFour refinement = e.refinement;
      edit_at_random(e, random);
      e.add(3, random);
      for (int i = 0; i < 3; ++i) {
        const VertexId v(static_cast<uint32_t>(random.below(e.mesh.vertex_slots())));
        Mesh::Star star;
        e.mesh.star(v, star);
        e.mesh.move_vertex(v, e.mesh.position(v) + 0.3 * e.size * random_direction(random));
        for (AabbTree& tree : e.trees) tree.refit(e.mesh, star.faces);
      }
      change.end(e.mesh);
      const auto exchange = [&] {
        std::vector<FaceId> faces;
        change.append_faces(e.mesh, faces);
        change.exchange(e.mesh);
        for (AabbTree& tree : e.trees) tree.update(e.mesh, faces);
        expect_boxes_nest(e.best(), e.mesh);
      };
      exchange();
      ASSERT_EQ(e.best().leaf_count(), e.mesh.live_faces());
      ASSERT_NO_FATAL_FAILURE(expect_answers_as_brute_force(e, random));
      if (random.below(2) == 0) {
        e.refinement = refinement;  // the next edits go on from here
        continue;
      }
      exchange();
      ASSERT_EQ(e.best().leaf_count(), e.mesh.live_faces());
      ASSERT_NO_FATAL_FAILURE(expect_answers_as_brute_force(e, random));
    }
  }
}

// Down to a ten-millionth of the mesh, around one point.
TEST(TreeEdits, finds_faces_a_ten_millionth_the_size_of_the_mesh) {
  Edited e(sphere(9, 14, 0.5));
  Random random(71);
  const Pose ray{{0.11, 2, 0.07}, {0, -1, 0}};
  const Interval range{0, 2};  // the upper side
  for (int level = 0; level < 22; ++level) {
    std::vector<RayHit> hits;
    e.best().crossings(e.mesh, ray, range, hits);
    ASSERT_EQ(hits.size(), 1u) << "level " << level;
    ASSERT_EQ(hits, brute_crossings(e.mesh, ray, range));
    std::vector<FaceId> found;
    const SweptCylinder line(ray, ray, 0, range);
    e.best().touched(e.mesh, line, found);
    ASSERT_TRUE(std::find(found.begin(), found.end(), hits[0].face) != found.end()) << "level " << level;
    if (!e.refinement.can_split(e.mesh, hits[0].face)) break;
    e.split(hits[0].face);
    e.update_trees();
  }
  std::vector<RayHit> hits;
  e.best().crossings(e.mesh, ray, range, hits);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_LT(longest_edge2(e.mesh.triangle(hits[0].face)), 1e-14);
}

// The first replacement is told when its faces have been split again, so its boxes are too small for the
// last.
TEST(TreeEdits, boxes_grow_after_a_late_replacement_update) {
  Edited e(plate(1));
  const double width = e.best().bounds().max.x - e.best().bounds().min.x;
  for (int i = 0; i < 40; ++i) e.split(FaceId(0));  // the slot of a part that gets smaller and smaller
  e.update_trees();
  EXPECT_EQ(e.best().bounds().max.x - e.best().bounds().min.x, width);
  expect_boxes_nest(e.best(), e.mesh);
  size_t faces = 0;
  std::vector<FaceId> found;
  const Pose above{{0, 1, 0}, {0, -1, 0}};
  e.best().touched(e.mesh, SweptCylinder(above, above, 3, {0, 9}), found);
  faces = found.size();
  EXPECT_EQ(faces, e.mesh.live_faces());
}

TEST(TreeEdits, every_box_shrinks_to_its_leaves_after_removals) {
  Edited e(grid(12, 1));
  Random random(81);
  while (e.mesh.live_faces() > 30) {
    const FaceId f(static_cast<uint32_t>(random.below(e.mesh.face_slots())));
    if (e.mesh.is_live(f)) e.remove(f);
  }
  // What is left of a box is not wider than the leaves in it.
  std::vector<AabbTree::Box> boxes;
  e.best().for_each_box(e.mesh, [&](const AabbTree::Box& box) { boxes.push_back(box); });
  for (size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].leaf) continue;
    Vec3 low(1e9), high(-1e9);
    for (size_t j = i + 1; j < boxes.size() && boxes[j].depth > boxes[i].depth; ++j) {
      low = glm::min(low, boxes[j].min);
      high = glm::max(high, boxes[j].max);
    }
    EXPECT_EQ(boxes[i].min, low);
    EXPECT_EQ(boxes[i].max, high);
  }
}

// The same mesh with other positions stands for one whose vertices have moved.
TEST(TreeEdits, finds_moved_faces_after_a_refit) {
  Soup soup = grid(10, 1);
  const Mesh before = build(soup).mesh;
  AabbTree tree(before);
  Random random(91);
  for (Vec3& p : soup.positions) p += 0.3 * random_direction(random);
  const Mesh after = build(soup).mesh;
  ASSERT_EQ(after.face_slots(), before.face_slots());
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < after.face_slots(); ++f) faces.emplace_back(f);
  tree.refit(after, faces);
  expect_boxes_nest(tree, after);
  for (int i = 0; i < 200; ++i) {
    const Pose ray{Vec3(random.uniform(-1, 1), 2, random.uniform(-1, 1)), {0, -1, 0}};
    std::vector<RayHit> hits;
    tree.crossings(after, ray, {0, 9}, hits);
    ASSERT_EQ(hits, brute_crossings(after, ray, {0, 9}));
  }
}

// The far rays err by more than floats do: rounding decides which of two neighbours each of them crosses.
TEST(TreeEdits, parallel_rays_from_near_and_far_equal_brute_force) {
  constexpr double kFar = 1e12;
  const Edited e(sphere(9, 14, 0.5));
  const Interval range{0, 4 * kFar};
  Random random(95);
  for (uint32_t f = 0; f < e.mesh.face_slots(); ++f) {
    const Triangle t = e.mesh.triangle(FaceId(f));
    const Vec3 target = 0.5 * t[0] + 0.5 * t[1], axis = random_direction(random);
    const std::vector<Pose> rays{{target - 2.0 * axis, axis}, {target - kFar * axis, axis}};
    for (const AabbTree& tree : e.trees) {
      std::vector<std::vector<RayHit>> found(rays.size());
      tree.crossings(e.mesh, rays, range, found);
      for (size_t r = 0; r < rays.size(); ++r)
        ASSERT_EQ(found[r], brute_crossings(e.mesh, rays[r], range))
            << "face " << f << " of seed 95, ray " << r;
    }
  }
}

TEST(TreeEdits, reported_bytes_grow_with_the_tree) {
  const Edited small(grid(4, 1)), large(grid(40, 1));
  EXPECT_GT(small.best().bytes(), 32 * small.best().leaf_count());
  EXPECT_GT(large.best().bytes(), 50 * large.best().leaf_count());
  EXPECT_LT(large.best().bytes(), 120 * large.best().leaf_count());
}

TEST(TreeEdits, a_copy_is_independent) {
  Edited e(grid(6, 1));
  const AabbTree copy = e.best();
  const size_t leaves = copy.leaf_count();
  for (uint32_t f = 0; f < 20; f += 2) e.best().remove(FaceId(f));
  EXPECT_EQ(copy.leaf_count(), leaves);
  size_t shown = 0;
  copy.for_each_box(e.mesh, [&](const AabbTree::Box& box) { shown += box.leaf; });
  EXPECT_EQ(shown, leaves);
}

}  // namespace
}  // namespace kerf::test
