#include "tests/support/same_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "core/world/world.h"

namespace kerf::test {

namespace {

// The boxes of the faces in the tree, in no order; those above them depend on how the tree was edited.
std::vector<std::tuple<double, double, bool>> leaves(const Body& body) {
  std::vector<std::tuple<double, double, bool>> all;
  body.tree.for_each_box(body.mesh, [&](const AabbTree::Box& b) {
    if (b.leaf) all.emplace_back(b.min.x + b.min.y + b.min.z, b.max.x + b.max.y + b.max.z, b.hit);
  });
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

void expect_same_body(const Body& a, const Body& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.named, b.named);
  EXPECT_EQ(a.piece_names, b.piece_names);
  EXPECT_EQ(a.hidden, b.hidden);
  EXPECT_EQ(a.solid, b.solid);
  EXPECT_EQ(a.placement.position, b.placement.position);
  ASSERT_EQ(a.mesh.face_slots(), b.mesh.face_slots());
  ASSERT_EQ(a.mesh.vertex_slots(), b.mesh.vertex_slots());
  EXPECT_EQ(a.mesh.live_faces(), b.mesh.live_faces());
  for (uint32_t v = 0; v < a.mesh.vertex_slots(); ++v)
    ASSERT_EQ(a.mesh.position(VertexId(v)), b.mesh.position(VertexId(v)));
  for (uint32_t f = 0; f < a.mesh.face_slots(); ++f) {
    const FaceId face(f);
    ASSERT_EQ(a.mesh.is_live(face), b.mesh.is_live(face));
    if (!a.mesh.is_live(face)) continue;
    ASSERT_EQ(a.mesh.corners(face), b.mesh.corners(face));
    const FaceData &x = a.mesh.data(face), &y = b.mesh.data(face);
    ASSERT_TRUE(x.base == y.base && x.element == y.element && x.piece == y.piece && x.halvings == y.halvings);
  }
  ASSERT_EQ(a.pieces.size(), b.pieces.size());
  for (uint32_t p = 0; p < a.pieces.size(); ++p) {
    EXPECT_EQ(a.pieces[p].faces, b.pieces[p].faces);
    EXPECT_EQ(a.pieces[p].area, b.pieces[p].area);
    EXPECT_EQ(a.pieces[p].moments, b.pieces[p].moments);
    EXPECT_EQ(a.pieces[p].cut_off.faces, b.pieces[p].cut_off.faces);
    EXPECT_EQ(a.pieces[p].cut_off.area, b.pieces[p].cut_off.area);
  }
  ASSERT_EQ(a.components.home.size(), b.components.home.size());
  for (uint32_t c = 0; c < a.components.home.size(); ++c)
    EXPECT_EQ(a.components.home[c], b.components.home[c]);
  EXPECT_EQ(a.bounds(), b.bounds());
  EXPECT_EQ(leaves(a), leaves(b));
}

void expect_same_world(const World& a, const World& b) {
  ASSERT_EQ(a.ids(), b.ids());
  for (const BodyId id : a.ids()) EXPECT_EQ(a.body(id).number, b.body(id).number);
  expect_same_bodies(a, b);
}

void expect_same_bodies(const World& a, const World& b) {
  EXPECT_EQ(state_hash(a), state_hash(b));
  const std::vector<BodyId> ids_a = a.ids(), ids_b = b.ids();
  ASSERT_EQ(ids_a.size(), ids_b.size());
  for (size_t i = 0; i < ids_a.size(); ++i) {
    SCOPED_TRACE("body " + std::to_string(ids_a[i].slot));
    const Body &body_a = a.body(ids_a[i]), &body_b = b.body(ids_b[i]);
    expect_same_body(body_a, body_b);
  }
}

}  // namespace kerf::test
