#include "core/world/joint.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(Joint, is_carried_by_the_faces_of_either_side_of_its_body) {
  Joints joints;
  Joint& joint = joints.all.emplace_back();
  joint.body = BodyId{3, 1};
  joint.sides[0].faces = {2, 5, 9};
  joint.sides[1].faces = {7};
  for (uint32_t f = 0; f < 12; ++f)
    EXPECT_EQ(joints.carries({3, 1}, FaceId(f)), f == 2 || f == 5 || f == 9 || f == 7) << f;
  EXPECT_FALSE(joints.carries({3, 2}, FaceId(5)));
  EXPECT_FALSE(joints.carries({4, 1}, FaceId(5)));
  EXPECT_FALSE(Joints().carries({3, 1}, FaceId(5)));
}

}  // namespace
}  // namespace kerf
