#include "core/mesh/face_batches.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

// The results of the mesh itself for the same faces, one by one.
void expect_as_one_by_one(const Mesh& mesh, FaceWalk& walk, const std::vector<ReachedFace>& batch) {
  walk.visit(batch);
  std::vector<FaceId> neighbours;
  for (size_t i = 0; i < batch.size(); ++i) {
    const FaceId f = batch[i].face;
    ASSERT_EQ(walk.is_live(i), mesh.is_live(f));
    if (!mesh.is_live(f)) continue;
    EXPECT_EQ(walk.area(i), triangle_area(mesh.triangle(f)));
    mesh.append_nearest_neighbours(f, neighbours);
  }
  ASSERT_EQ(walk.neighbours().size(), neighbours.size());
  for (size_t i = 0; i < neighbours.size(); ++i) ASSERT_EQ(walk.neighbours()[i].face, neighbours[i]);
}

FaceId any_face(const Mesh& mesh, Random& random) {
  return FaceId(static_cast<uint32_t>(random.below(mesh.face_slots())));
}

// Splits, flips or removes a face.
void edit(Mesh& mesh, FaceId f, Random& random) {
  std::vector<Mesh::FaceSplit> splits;
  const auto c = mesh.corners(f);
  const uint64_t what = random.below(3);
  if (what == 0) {
    mesh.split_edge(f, c[0], c[1], splits);
  } else if (what == 1 && mesh.can_flip_edge(f, c[1], c[2])) {
    mesh.flip_edge(f, c[1], c[2]);
  } else if (what == 2) {
    mesh.remove_face(f);
  }
}

// Faces that were reached before some edits, and dead ones, are visited like any others.
TEST(FaceWalk, finds_neighbours_of_faces_visited_before_edits) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    for (const auto& [name, soup] : mesh_classes()) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Mesh mesh = build(soup).mesh;
      FaceWalk walk(mesh);
      std::vector<ReachedFace> batch{{any_face(mesh, random)}};
      for (int turn = 0; turn < 30; ++turn) {
        expect_as_one_by_one(mesh, walk, batch);
        if (HasFailure()) return;
        const auto reached = walk.neighbours();
        walk.prefetch(reached);
        if (!reached.empty()) batch.assign(reached.begin(), reached.end());
        batch.resize(std::min<size_t>(batch.size(), 50));
        batch.push_back({any_face(mesh, random)});
        for (int edits = 0; edits < 3; ++edits) {
          const FaceId f = any_face(mesh, random);
          if (mesh.is_live(f)) edit(mesh, f, random);
        }
      }
    }
  }
}

TEST(FaceWalk, reads_the_corners_of_faces) {
  const Mesh mesh = build(torus(16, 10, 0.5, 0.2)).mesh;
  FaceWalk walk(mesh);
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); f += 3) faces.push_back(FaceId(f));
  const auto triangles = walk.triangles(faces);
  ASSERT_EQ(triangles.size(), faces.size());
  for (size_t i = 0; i < faces.size(); ++i) EXPECT_EQ(triangles[i], mesh.triangle(faces[i]));
  EXPECT_TRUE(walk.triangles({}).empty());
}

}  // namespace
}  // namespace kerf::test
