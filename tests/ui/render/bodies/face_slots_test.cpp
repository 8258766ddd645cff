#include "ui/render/bodies/face_slots.h"

#include <gtest/gtest.h>

#include <glm/gtc/packing.hpp>

#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

using Ranges = std::vector<SlotRange>;
constexpr std::array<float, 3> kNoRim{60000, 60000, 60000};

TEST(DirtySlots, are_returned_as_few_ranges_and_cleared) {
  DirtySlots dirty;
  for (const uint32_t slot : {9u, 3u, 4u, 3u, 20u}) dirty.mark(slot);
  EXPECT_EQ(dirty.take(0, 1000), (Ranges{{3, 5}, {9, 10}, {20, 21}}));
  EXPECT_TRUE(dirty.empty());
  EXPECT_TRUE(dirty.take(0, 1000).empty());
}

TEST(DirtySlots, small_gaps_are_bridged) {
  DirtySlots dirty;
  for (const uint32_t slot : {3u, 6u, 12u}) dirty.mark(slot);
  EXPECT_EQ(dirty.take(2, 1000), (Ranges{{3, 7}, {12, 13}}));
}

TEST(DirtySlots, no_range_crosses_a_chunk) {
  DirtySlots dirty;
  dirty.mark_all(10);
  dirty.mark(12);
  EXPECT_EQ(dirty.take(100, 4), (Ranges{{0, 4}, {4, 8}, {8, 10}, {12, 13}}));
}

TEST(DirtySlots, all_are_returned_in_parts_and_only_once) {
  DirtySlots dirty;
  dirty.mark_all(10);
  EXPECT_EQ(dirty.take(0, 100, 4), (Ranges{{0, 4}}));
  EXPECT_TRUE(dirty.has_all());
  for (const uint32_t slot : {1u, 6u, 12u}) dirty.mark(slot);
  EXPECT_EQ(dirty.take(0, 100, 4), (Ranges{{1, 2}, {4, 8}, {12, 13}}));
  EXPECT_EQ(dirty.take(0, 100, 4), (Ranges{{8, 10}}));
  EXPECT_TRUE(dirty.empty());
}

TEST(LiveList, the_last_element_replaces_a_removed_one) {
  LiveList live;
  live.make_room(10);
  for (const uint32_t slot : {2u, 5u, 7u}) EXPECT_TRUE(live.set(slot, true));
  EXPECT_EQ(live.take_changes(0), (Ranges{{0, 3}}));
  EXPECT_TRUE(live.set(2, false));
  EXPECT_FALSE(live.set(2, false));
  EXPECT_EQ(std::vector<uint32_t>(live.slots().begin(), live.slots().end()), (std::vector<uint32_t>{7, 5}));
  EXPECT_EQ(live.take_changes(0), (Ranges{{0, 1}}));
}

TEST(LiveList, adding_and_removing_leaves_nothing_to_send) {
  LiveList live;
  live.make_room(10);
  live.set(1, true);
  live.take_changes(0);
  live.set(4, true);
  live.set(4, false);
  EXPECT_TRUE(live.take_changes(0).empty());
}

TEST(FaceVertices, collapse_to_a_point_for_a_dead_face) {
  Mesh mesh = test::build(test::plate(1)).mesh;
  const FloatFrame frame = FloatFrame::around({0, 0, 0}, {1, 0, 1});
  const BaseFaces bases(mesh, frame);
  mesh.remove_face(FaceId(0));
  EXPECT_EQ(face_vertices(mesh, bases, frame, FaceId(0), kNoRim), FaceVertices{});
  EXPECT_NE(face_vertices(mesh, bases, frame, FaceId(1), kNoRim), FaceVertices{});
}

TEST(FaceVertices, contain_material_halvings_and_rim_distances) {
  Mesh mesh = test::build(test::plate(1)).mesh;
  const FloatFrame frame = FloatFrame::around({0, 0, 0}, {1, 0, 1});
  const BaseFaces bases(mesh, frame);
  mesh.edit_data(FaceId(0)).material = 7;
  mesh.edit_data(FaceId(0)).halvings = 3;
  const FaceVertices corners = face_vertices(mesh, bases, frame, FaceId(0), {0, 0.25f, 1.5f});
  for (const FaceVertex& v : corners) {
    EXPECT_EQ(v.material, 7);
    EXPECT_EQ(v.halvings, 3);
  }
  EXPECT_EQ(glm::unpackHalf1x16(corners[0].rim), 0);
  EXPECT_EQ(glm::unpackHalf1x16(corners[1].rim), 0.25f);
  EXPECT_EQ(glm::unpackHalf1x16(corners[2].rim), 1.5f);
}

TEST(PackedPiece, is_zero_only_for_label_zero) {
  EXPECT_EQ(packed_piece(0), 0);
  for (const uint32_t label : {1u, 2u, 65535u, 65536u, 131070u, 131071u, 0xffffffffu}) {
    EXPECT_NE(packed_piece(label), 0) << label;
  }
}

// The shading of a split face is that of its base: its corners get what the base's corners say there.
TEST(BaseFaces, split_faces_keep_the_smooth_normals_of_a_sphere) {
  Mesh mesh = test::build(test::sphere(16, 24, 1)).mesh;
  const FloatFrame frame = FloatFrame::around({-1, -1, -1}, {1, 1, 1});
  const BaseFaces bases(mesh, frame);
  std::vector<Mesh::FaceSplit> splits;
  const std::array<VertexId, 3> corners = mesh.corners(FaceId(40));
  mesh.split_edge(FaceId(40), corners[0], corners[1], splits);
  for (const Mesh::FaceSplit& split : splits) {
    for (const FaceVertex& v : face_vertices(mesh, bases, frame, split.added, kNoRim)) {
      const glm::vec3 at = glm::normalize(glm::vec3(v.position[0], v.position[1], v.position[2]));
      EXPECT_GT(glm::dot(at, glm::normalize(unpack_normal(v.normal))), 0.99f);
    }
  }
}

TEST(BaseFaces, an_edge_sharper_than_the_crease_stays_sharp) {
  // Two faces at a right angle.
  Soup soup;
  soup.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}, {0, 3, 1}};
  soup.faces_in_file = soup.triangles_in_file = 2;
  const Mesh mesh = test::build(soup).mesh;
  const FloatFrame frame = FloatFrame::around({0, 0, 0}, {1, 1, 1});
  const BaseFaces bases(mesh, frame);
  for (uint32_t f = 0; f < 2; ++f) {
    const Triangle t = mesh.triangle(FaceId(f));
    const glm::vec3 plane(glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0])));
    for (const FaceVertex& v : face_vertices(mesh, bases, frame, FaceId(f), kNoRim)) {
      EXPECT_GT(glm::dot(plane, unpack_normal(v.normal)), 0.999f);
    }
  }
}

TEST(FloatFrame, normalises_any_size_to_about_one) {
  for (const double size : {1e-30, 1e-6, 1.0, 1e6, 1e39}) {
    const FloatFrame frame = FloatFrame::around(Vec3(-size), Vec3(3 * size));
    const glm::vec3 corner = frame.to_float(Vec3(3 * size));
    EXPECT_GE(corner.x, 0.5f) << size;
    EXPECT_LE(corner.x, 1.0f) << size;
  }
}

}  // namespace
}  // namespace kerf
