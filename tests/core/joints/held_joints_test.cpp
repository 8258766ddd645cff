#include "core/joints/joined_parts.h"

#include <gtest/gtest.h>

#include <array>

#include "core/edit/body_edit.h"
#include "core/edit/separation.h"
#include "tests/support/jointed.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"

namespace kerf::test {
namespace {

// A door beside a frame, on a hinge of which both sides reach 0.2 m.
class DoorOnHinge : public testing::Test {
 protected:
  DoorOnHinge() {
    JointDescription hinge;
    hinge.kind = Joint::Kind::kHinge;
    hinge.parts = {"door", "frame"};
    hinge.anchor = {0.55, 0, 0};
    hinge.radius = 0.2;
    const std::array sheets{NamedSheet{"door", rectangle(1, 1, 10)},
                            NamedSheet{"frame", rectangle(1, 1, 10), {1.1, 0, 0}}};
    world_ = jointed_world(sheets, {&hinge, 1});
  }
  Body& body() { return world_.body(world_.ids().front()); }
  // Removes the faces whose middles lie between two places along x.
  void remove_between(double low, double high) {
    std::vector<FaceId> removed;
    for (uint32_t f = 0; f < body().mesh.face_slots(); ++f) {
      if (!body().mesh.is_live(FaceId(f))) continue;
      const Triangle t = body().mesh.triangle(FaceId(f));
      const double x = (t[0].x + t[1].x + t[2].x) / 3;
      if (x > low && x < high) removed.emplace_back(f);
    }
    ASSERT_FALSE(removed.empty());
    BodyEdit(body()).remove(removed);
    settle(body());
  }

  World world_;
};

TEST_F(DoorOnHinge, is_held_by_its_frame) {
  const auto held = held_joints(world_);
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].joint, 0u);
  EXPECT_NE(held[0].parts[0], held[0].parts[1]);
  EXPECT_EQ(part_of(world_.ids().front(), body(), FaceId(0)), held[0].parts[0]);
}

TEST_F(DoorOnHinge, is_released_when_no_carrying_face_is_left) {
  remove_between(0.25, 0.6);
  EXPECT_TRUE(held_joints(world_).empty());
}

TEST_F(DoorOnHinge, is_held_while_some_connected_faces_are_left) {
  remove_between(0.44, 0.51);
  EXPECT_EQ(held_joints(world_).size(), 1u);
}

TEST_F(DoorOnHinge, stays_held_when_cut_far_from_its_hinge) {
  remove_between(-0.3, -0.2);
  const auto held = held_joints(world_);
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].parts[0].label, part_of(world_.ids().front(), body(), FaceId(199)).label);
}

TEST(HeldJoints, are_empty_in_a_world_without_joints) {
  World world;
  add(world, rectangle(1, 1, 2), Vec3(0));
  EXPECT_TRUE(held_joints(world).empty());
}

}  // namespace
}  // namespace kerf::test
