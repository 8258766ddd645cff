#include "ui/render/face_slots.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "ui/render/live_list.h"

namespace kerf {
namespace {

using Ranges = std::vector<SlotRange>;

TEST(DirtySlots, are_taken_as_few_ranges_and_are_clean_after) {
  DirtySlots dirty;
  for (const uint32_t slot : {9u, 3u, 4u, 3u, 20u}) dirty.mark(slot);
  EXPECT_EQ(dirty.take(0, 1000), (Ranges{{3, 5}, {9, 10}, {20, 21}}));
  EXPECT_TRUE(dirty.empty());
  EXPECT_TRUE(dirty.take(0, 1000).empty());
}

TEST(DirtySlots, small_gaps_are_taken_along) {
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

TEST(DirtySlots, a_delta_marks_born_gone_and_relabelled) {
  DirtySlots dirty;
  BodyDelta delta;
  delta.born = {FaceId(1)};
  delta.gone = {FaceId(5)};
  delta.relabelled = {FaceId(2)};
  dirty.mark(delta);
  EXPECT_EQ(dirty.take(0, 100), (Ranges{{1, 3}, {5, 6}}));
}

TEST(DirtySlots, all_are_handed_out_a_part_at_a_time_and_each_once) {
  DirtySlots dirty;
  dirty.mark_all(10);
  EXPECT_EQ(dirty.take(0, 100, 4), (Ranges{{0, 4}}));
  EXPECT_TRUE(dirty.has_all());
  for (const uint32_t slot : {1u, 6u, 12u}) dirty.mark(slot);
  EXPECT_EQ(dirty.take(0, 100, 4), (Ranges{{1, 2}, {4, 8}, {12, 13}}));
  EXPECT_EQ(dirty.take(0, 100, 4), (Ranges{{8, 10}}));
  EXPECT_TRUE(dirty.empty());
}

TEST(LiveList, the_last_takes_the_place_of_what_goes) {
  LiveList live(10);
  for (const uint32_t slot : {2u, 5u, 7u}) EXPECT_TRUE(live.set(slot, true));
  EXPECT_EQ(live.take_changes(0), (Ranges{{0, 3}}));
  EXPECT_TRUE(live.set(2, false));
  EXPECT_FALSE(live.set(2, false));
  EXPECT_EQ(std::vector<uint32_t>(live.slots().begin(), live.slots().end()), (std::vector<uint32_t>{7, 5}));
  EXPECT_EQ(live.take_changes(0), (Ranges{{0, 1}}));
}

TEST(LiveList, what_comes_and_goes_leaves_nothing_to_send) {
  LiveList live(10);
  live.set(1, true);
  live.take_changes(0);
  live.set(4, true);
  live.set(4, false);
  EXPECT_TRUE(live.take_changes(0).empty());
}

TEST(FaceVertices, of_a_dead_face_are_one_point) {
  Mesh mesh = test::build(test::plate(1)).mesh;
  const FloatFrame frame = FloatFrame::around({0, 0, 0}, {1, 0, 1});
  const BaseFaces bases(mesh, frame);
  mesh.remove_face(FaceId(0));
  EXPECT_EQ(face_vertices(mesh, bases, frame, FaceId(0)), FaceVertices{});
  EXPECT_NE(face_vertices(mesh, bases, frame, FaceId(1)), FaceVertices{});
}

TEST(FaceVertices, attributes_tell_fineness_material_and_piece) {
  FaceData data;
  data.material = 7;
  data.piece = 2;
  EXPECT_EQ(pack_attributes(data, 6.25f), 50u | 7u << 8 | 2u << 16);
  data.piece = 65536;
  EXPECT_NE(pack_attributes(data, 0) >> 16, 0u);
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
    for (const FaceVertex& v : face_vertices(mesh, bases, frame, split.added)) {
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
    for (const FaceVertex& v : face_vertices(mesh, bases, frame, FaceId(f))) {
      EXPECT_GT(glm::dot(plane, unpack_normal(v.normal)), 0.999f);
    }
  }
}

TEST(FloatFrame, brings_any_size_to_about_one) {
  for (const double size : {1e-30, 1e-6, 1.0, 1e6, 1e39}) {
    const FloatFrame frame = FloatFrame::around(Vec3(-size), Vec3(3 * size));
    const glm::vec3 corner = frame.to_float(Vec3(3 * size));
    EXPECT_GE(corner.x, 0.5f) << size;
    EXPECT_LE(corner.x, 1.0f) << size;
  }
}

}  // namespace
}  // namespace kerf
