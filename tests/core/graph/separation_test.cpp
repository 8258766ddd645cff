#include "core/graph/separation.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// Removes random clumps of faces and compares every settling with a full search before and after.
TEST(Separation, equals_the_full_search_on_random_removals) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Body body = make_body(name, build(soup));
      Random random(seed);
      Separation separation;
      while (body.mesh.live_faces() > 0) {
        std::vector<uint32_t> before, after;
        label_components(body.mesh, before);
        const size_t pieces = body.pieces.size();
        for (uint64_t i = 0, n = 1 + random.below(6); i < n; ++i) {
          const FaceId f(static_cast<uint32_t>(random.below(body.mesh.face_slots())));
          if (!body.mesh.is_live(f)) continue;
          Piece& piece = body.pieces.edit(body.mesh.data(f).piece);
          --piece.faces;
          piece.area -= triangle_area(body.mesh.triangle(f));
          separation.note_removal(body.mesh, f);
          body.mesh.remove_face(f);
        }
        const Separation::Result result = separation.settle(body);
        label_components(body.mesh, after);

        std::map<uint32_t, std::set<uint32_t>> parts;  // of each old component
        std::map<uint32_t, uint32_t> label_of;         // of each new one
        for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
          if (!body.mesh.is_live(FaceId(f))) continue;
          parts[before[f]].insert(after[f]);
          const uint32_t label = body.mesh.data(FaceId(f)).piece;
          ASSERT_EQ(label_of.try_emplace(after[f], label).first->second, label);
        }
        size_t came_off = 0;
        for (const auto& [component, set] : parts) came_off += set.size() - 1;
        ASSERT_EQ(result.new_pieces.size(), came_off);
        ASSERT_EQ(body.pieces.size(), pieces + came_off);
      }
    }
  }
}

TEST(Separation, leaves_the_label_with_the_part_of_the_largest_area_not_of_the_most_faces) {
  // A strip: many small faces, one that is taken away, and one large one.
  Soup soup = grid(6, 1);
  const uint32_t n = static_cast<uint32_t>(soup.positions.size());
  soup.positions.push_back({0.6, 0, -0.5});
  soup.positions.push_back({50, 0, 50});
  const uint32_t corner = 6, below = 13;  // the right border of the grid's first row
  soup.triangles.push_back({corner, below, n});
  soup.triangles.push_back({n, below, n + 1});
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  Body body = make_body("strip", build(soup));
  const FaceId bridge(static_cast<uint32_t>(soup.triangles.size() - 2)), large(bridge.index + 1);
  Separation separation;
  separation.note_removal(body.mesh, bridge);
  body.mesh.remove_face(bridge);
  const auto result = separation.settle(body);
  ASSERT_EQ(result.new_pieces.size(), 1u);
  EXPECT_EQ(body.mesh.data(large).piece, 0u);
  EXPECT_EQ(body.mesh.data(FaceId(0)).piece, 1u);
  EXPECT_EQ(result.relabelled.size(), 72u);
}

TEST(Separation, does_not_cut_off_what_never_hung_together) {
  Body body = make_body("two", build(both(sphere(5, 6, 0.3), moved(sphere(5, 6, 0.3), {1, 0, 0}, 1))));
  Separation separation;
  for (const uint32_t f : {0u, 1u, 60u, 61u}) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    separation.note_removal(body.mesh, FaceId(f));
    body.mesh.remove_face(FaceId(f));
  }
  EXPECT_TRUE(separation.settle(body).new_pieces.empty());
}

TEST(Separation, does_not_join_over_a_corner) {
  Soup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  soup.triangles = {{0, 1, 2}, {0, 3, 4}};
  std::vector<uint32_t> label;
  EXPECT_EQ(label_components(build(soup).mesh, label), 2u);
}

}  // namespace
}  // namespace kerf::test
