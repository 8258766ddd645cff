#include "core/game/arena/arena.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/support/jointed.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// A door beside a frame, and a joint between them.
ModelBody door_in_frame() {
  const std::array sheets{test::NamedSheet{"door", test::rectangle(1, 1, 2)},
                          test::NamedSheet{"frame", test::rectangle(1, 1, 2), {1.1, 0, 0}}};
  return {make_body("gate", test::build(test::assembled(sheets))), {}};
}

JointDescription hinge() {
  JointDescription joint;
  joint.kind = Joint::Kind::kHinge;
  joint.parts = {"door", "frame"};
  joint.anchor = {0.55, 0, 0};
  return joint;
}

TEST(ModelBody, adds_its_joints_to_each_world_it_is_added_to) {
  ModelBody model = door_in_frame();
  ASSERT_TRUE(add_joints(std::array{hinge()}, model));
  ASSERT_EQ(model.joints.size(), 1u);
  World world;
  const BodyId first = add_body(world, model, 3), second = add_body(world, model, 4);
  EXPECT_EQ(first.generation, 3u);
  EXPECT_EQ(second.generation, 4u);
  ASSERT_EQ(world.joints().all.size(), 2u);
  EXPECT_EQ(world.joints().all[0].body, first);
  EXPECT_EQ(world.joints().all[1].body, second);
  EXPECT_EQ(world.joints().all[1].anchor, hinge().anchor);
  EXPECT_EQ(world.body(second).mesh.live_faces(), model.body.mesh.live_faces());
}

TEST(ModelBody, rejects_a_joint_of_a_missing_part) {
  ModelBody model = door_in_frame();
  JointDescription wrong = hinge();
  wrong.parts[1] = "wall";
  const Status added = add_joints(std::array{wrong}, model);
  ASSERT_FALSE(added);
  EXPECT_NE(added.error().message.find("wall"), std::string::npos) << added.error().message;
}

}  // namespace
}  // namespace kerf
