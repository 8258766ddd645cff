#include "core/world/connectivity.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(Joint, is_carried_by_faces_on_both_sides) {
  Joints joints;
  Joint& joint = joints.all.emplace_back();
  joint.body = BodyId{3, 1};
  joint.sides[0].faces = {2, 5, 9};
  joint.sides[1].faces = {7};
  joints.all.emplace_back().body = BodyId{4, 1};
  const std::vector<const JointSide*> sides = joints.sides_of({3, 1});
  for (uint32_t f = 0; f < 12; ++f) {
    const auto carries = [&](const JointSide* side) { return side->carries(FaceId(f)); };
    EXPECT_EQ(std::ranges::any_of(sides, carries), f == 2 || f == 5 || f == 9 || f == 7) << f;
  }
  EXPECT_EQ(sides.size(), 2u);
  EXPECT_TRUE(joints.sides_of({3, 2}).empty());
  EXPECT_TRUE(Joints().sides_of({3, 1}).empty());
}

}  // namespace
}  // namespace kerf
