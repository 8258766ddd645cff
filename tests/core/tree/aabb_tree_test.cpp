#include "core/tree/aabb_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/measures.h"
#include "core/mesh/refinement.h"
#include "core/tree/queries.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

std::vector<FaceId> brute_touched(const Mesh& mesh, const SweptCylinder& beam) {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f)) && beam.touches(mesh.triangle(FaceId(f)))) faces.emplace_back(f);
  }
  return faces;
}

// The extent of a mesh, for beams of the right size.
struct Frame {
  Vec3 centre;
  double size;
};
Frame frame_of(const MeshReport& r) { return {0.5 * r.min + 0.5 * r.max, glm::length(r.max - r.min)}; }

SweptCylinder random_beam(const Frame& frame, Random& random, bool tilt) {
  const Vec3 axis = random_direction(random);
  const Vec3 at = frame.centre + 0.4 * frame.size * random_direction(random) - frame.size * axis;
  const Vec3 end = glm::normalize(axis + (tilt ? 0.1 : 0.0) * random_direction(random));
  return {{at, axis},
          {at + 0.3 * frame.size * random_direction(random), tilt ? end : axis},
          frame.size * random.uniform(0, 0.1),
          {0, frame.size * random.uniform(0.5, 3)}};
}

// Children lie below boxes that were entered, and every face that was tested is counted.
void expect_visits_make_sense(const TouchedWalk& traced, const AabbTree& tree) {
  size_t tested = 0;
  for (size_t i = 1; i < traced.visits.size(); ++i) {
    const TouchedWalk::Visit& visit = traced.visits[i];
    ASSERT_LT(visit.parent, i);
    ASSERT_EQ(traced.visits[visit.parent].outcome, TouchedWalk::Outcome::kEntered);
    ASSERT_EQ(visit.box.depth, traced.visits[visit.parent].box.depth + 1);
    ASSERT_EQ(visit.outcome == TouchedWalk::Outcome::kCulled, visit.outside != TouchedWalk::Side::kNone);
    tested +=
        visit.outcome == TouchedWalk::Outcome::kMissed || visit.outcome == TouchedWalk::Outcome::kTouched;
  }
  ASSERT_EQ(tested, traced.counts.faces);
  ASSERT_LE(traced.visits.size(), tree.box_count() + tree.leaf_count());
}

void expect_touched_equals_brute_force(AabbTree& tree, const Mesh& mesh, const Frame& frame, Random& random) {
  for (int i = 0; i < 12; ++i) {
    const SweptCylinder beam = random_beam(frame, random, i % 3 == 0);
    const TouchedWalk traced = trace_touched(tree, mesh, beam);
    std::vector<FaceId> found;
    const QueryCounts counts = tree.touched(mesh, beam, found);
    std::sort(found.begin(), found.end());
    std::vector<FaceId> shown = traced.touched;
    std::sort(shown.begin(), shown.end());
    ASSERT_EQ(shown, found);
    ASSERT_EQ(traced.counts.boxes, counts.boxes);
    ASSERT_EQ(traced.counts.faces, counts.faces);
    expect_visits_make_sense(traced, tree);
    ASSERT_EQ(found, brute_touched(mesh, beam));
  }
}

TEST(AabbTree, touched_faces_equal_brute_force_through_random_edits) {
  for (const auto& [name, soup] : mesh_classes()) {
    SCOPED_TRACE(name);
    BuiltMesh built = build(soup);
    const Frame frame = frame_of(built.report);
    Mesh& mesh = built.mesh;
    AabbTree tree(mesh);
    OneToFour refinement;
    Random random(21);
    expect_touched_equals_brute_force(tree, mesh, frame, random);
    for (int round = 0; round < 10; ++round) {
      for (int i = 0; i < 10; ++i) {
        const FaceId f(static_cast<uint32_t>(random.below(mesh.face_slots())));
        if (!mesh.is_live(f)) continue;
        if (random.below(4) > 0 && mesh.data(f).halvings < 16) {
          std::vector<Replacement> replaced;
          refinement.split(mesh, f, replaced);
          for (const auto& r : replaced) tree.replace(mesh, {&r, 1});
        } else {
          const auto element = refinement.element(mesh, f);
          refinement.forget(mesh, f);
          for (int k = 0; k < element.face_count; ++k) {
            tree.remove(element.faces[k]);
            mesh.remove_face(element.faces[k]);
          }
        }
      }
      ASSERT_EQ(tree.leaf_count(), mesh.live_faces());
      expect_touched_equals_brute_force(tree, mesh, frame, random);
    }
  }
}

// Far from zero, doubles do not resolve the middle between the two faces.
TEST(AabbTree, finds_all_faces_of_a_mesh_a_few_roundings_wide) {
  const double far = 0x1p20, unit = 0x1p-32;  // the distance between doubles there
  Soup soup = plate(1);
  soup.positions.clear();
  for (const double x : {0.0, 3.0}) {
    for (const Vec2& p : {Vec2(-1.5, -1.5), Vec2(1.5, -1.5), Vec2(0, 1.5)})
      soup.positions.push_back({far + x * unit, p.x * unit, p.y * unit});
  }
  soup.triangles = {{0, 1, 2}, {3, 4, 5}};
  soup.faces_in_file = soup.triangles_in_file = 2;
  const Mesh mesh = build(soup).mesh;
  const AabbTree tree(mesh);
  const Pose pose{{far - 4 * unit, 0, 0}, {1, 0, 0}};
  std::vector<FaceId> found;
  tree.touched(mesh, SweptCylinder(pose, pose, unit, {0, 100 * unit}), found);
  EXPECT_EQ(found.size(), 2u);
}

TEST(AabbTree, is_empty_when_the_last_face_is_removed) {
  Mesh mesh = build(plate(1)).mesh;
  AabbTree tree(mesh);
  tree.remove(FaceId(0));
  tree.remove(FaceId(1));
  EXPECT_EQ(tree.box_count(), 0u);
  std::vector<FaceId> found;
  const Pose pose{{0, 1, 0}, {0, -1, 0}};
  tree.touched(mesh, SweptCylinder(pose, pose, 1, {0, 9}), found);
  EXPECT_TRUE(found.empty());
}

// Sorting takes the time from 15 to 80 %.
TEST(AabbTree, is_not_built_when_stopped_while_sorting) {
  const Mesh mesh = build(grid(64, 1)).mesh;
  for (const double limit : {0.3, 0.5, 0.7}) {
    const Progress stop{[&](double done) { return done < limit; }};
    EXPECT_FALSE(AabbTree::build(mesh, &stop)) << "stopped at " << limit;
  }
  const Progress on{[](double) { return true; }};
  const Result<AabbTree> built = AabbTree::build(mesh, &on);
  ASSERT_TRUE(built.ok());
  EXPECT_EQ(built->leaf_count(), mesh.live_faces());
}

TEST(AabbTree, boxes_contain_their_children_and_shrink_after_a_removal) {
  Mesh mesh = build(grid(8, 1)).mesh;
  AabbTree tree(mesh);
  const double width = tree.bounds().max.x - tree.bounds().min.x;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    const Triangle t = mesh.triangle(FaceId(f));
    if (std::max({t[0].x, t[1].x, t[2].x}) > 0.01) tree.remove(FaceId(f));
  }
  tree.fit_bounds(mesh);
  EXPECT_NEAR(tree.bounds().max.x - tree.bounds().min.x, width / 2, 1e-6);
}

TEST(AabbTree, has_exact_bounds_after_corners_moved_by_less_than_floats_resolve) {
  Mesh mesh = build(plate(1)).mesh;
  AabbTree tree(mesh);
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) faces.emplace_back(f);
  const VertexId corner = mesh.corners(FaceId(0))[0];
  const Vec3 at = mesh.position(corner);
  for (const double factor : {1 + 1e-12, 1.0}) {
    mesh.move_vertex(corner, factor * at);
    tree.update(mesh, faces);
    EXPECT_EQ(tree.bounds(), *bounds_of(mesh, nullptr));
  }
}

TEST(AabbTree, reports_boxes_of_hit_faces) {
  Mesh mesh = build(grid(8, 1)).mesh;
  const AabbTree tree(mesh);
  const auto hit_boxes = [&](bool leaves) {
    size_t hit = 0;
    tree.for_each_box(mesh, [&](const AabbTree::Box& box) { hit += box.hit && box.leaf == leaves; });
    return hit;
  };
  EXPECT_EQ(hit_boxes(true) + hit_boxes(false), 0u);
  std::vector<FaceId> found, near;
  const Pose pose{{0.3, 1, 0.3}, {0, -1, 0}};
  const QueryCounts counts = tree.touched(mesh, SweptCylinder(pose, pose, 0.01, {0, 9}), found, &near);
  for (const FaceId f : near) mesh.edit_data(f).hit = true;
  EXPECT_EQ(hit_boxes(true), near.size());
  EXPECT_GE(hit_boxes(true), found.size());
  EXPECT_GE(hit_boxes(false), 2u);  // the root and one below it
  EXPECT_LT(hit_boxes(true) + hit_boxes(false), tree.box_count() / 4);
  EXPECT_LT(counts.faces, 20u);
}

TEST(AabbTree, counts_the_reported_boxes) {
  Random random(51);
  Mesh mesh = build(grid(6, 1)).mesh;
  AabbTree tree(mesh);
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    size_t boxes = 0, leaves = 0;
    tree.for_each_box(mesh, [&](const AabbTree::Box& box) {
      ++boxes;
      leaves += box.leaf;
    });
    ASSERT_EQ(boxes, tree.box_count());
    ASSERT_EQ(leaves, tree.leaf_count());
    tree.remove(FaceId(f));
  }
  EXPECT_EQ(tree.box_count(), 0u);
}

TEST(AabbTree, crossings_equal_brute_force) {
  for (const auto& [name, soup] : mesh_classes()) {
    const BuiltMesh built = build(soup);
    const AabbTree tree(built.mesh);
    const Frame frame = frame_of(built.report);
    Random random(31);
    for (int i = 0; i < 60; ++i) {
      const Vec3 axis = random_direction(random);
      const Pose ray{frame.centre - frame.size * axis + 0.3 * frame.size * random_direction(random), axis};
      const Interval range{0.2 * frame.size, 1.5 * frame.size};
      std::vector<RayHit> found, all;
      tree.crossings(built.mesh, ray, range, found);
      // Each face in a tree of its own is the same test without culling by neighbours.
      const SweptCylinder line(ray, ray, 0, {0, 9 * frame.size});
      for (const FaceId f : brute_touched(built.mesh, line)) all.push_back({f, 0});
      for (const RayHit& hit : found) {
        const Vec3 at = ray.origin + hit.length * axis;
        const Triangle t = built.mesh.triangle(hit.face);
        const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
        EXPECT_LE(std::abs(glm::dot(at - t[0], normal)), 1e-9 * glm::length(normal) * frame.size) << name;
        EXPECT_TRUE(hit.length >= range.low && hit.length <= range.high) << name;
      }
      EXPECT_LE(found.size(), all.size()) << name;
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](const RayHit& a, const RayHit& b) {
        return a.length < b.length;
      })) << name;
    }
  }
}

// Through vertices, middles of edges and middles of faces of closed surfaces: in as often as out.
TEST(AabbTree, crossings_of_a_closed_surface_are_even) {
  Random random(41);
  for (const Soup& soup :
       {sphere(9, 14, 0.5), torus(14, 9, 0.5, 0.2), moved(sphere(9, 14, 0.5), {1e5, 0, 0}, 1)}) {
    const BuiltMesh built = build(soup);
    const AabbTree tree(built.mesh);
    const Frame frame = frame_of(built.report);
    for (uint32_t f = 0; f < built.mesh.face_slots(); ++f) {
      const Triangle t = built.mesh.triangle(FaceId(f));
      for (const Vec3& target : {t[0], 0.5 * t[0] + 0.5 * t[1], (t[0] + t[1] + t[2]) / 3.0}) {
        const Vec3 axis = random_direction(random);
        std::vector<RayHit> hits;
        tree.crossings(built.mesh, {target - 2 * frame.size * axis, axis}, {0, 9 * frame.size}, hits);
        EXPECT_EQ(hits.size() % 2, 0u) << "face " << f;
      }
    }
  }
}

}  // namespace
}  // namespace kerf::test
