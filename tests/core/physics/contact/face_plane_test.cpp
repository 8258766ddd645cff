#include "core/physics/contact/penetration.h"

#include <gtest/gtest.h>

#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

TEST(FacePlane, faces_the_origin_of_the_ray) {
  test::MovingSheets sheets;
  sheets.add(test::rectangle(1, 1, 2), {7, 8, 9});
  const MovingBody& sheet = sheets.bodies()[0];
  for (const double side : {1.0, -1.0}) {
    const auto plane = face_between(sheet, {0.2, 0.5 * side, 0.1}, {0.2, -0.5 * side, 0.1});
    ASSERT_TRUE(plane);
    EXPECT_NEAR(glm::distance(plane->at, Vec3(0.2, 0, 0.1)), 0, 1e-12);
    EXPECT_EQ(plane->normal, Vec3(0, side, 0));
    EXPECT_NEAR(plane->distance_to({5, 2, 5}), 2 * side, 1e-12);
  }
}

TEST(FacePlane, is_the_plane_of_the_first_face_within_the_length) {
  test::MovingSheets sheets;
  sheets.add(test::closed_box({1, 1, 1}), Vec3(0));
  const MovingBody& box = sheets.bodies()[0];
  EXPECT_NEAR(face_along(box, {0.1, 0.2, -3}, {0, 0, 1}, 9)->at.z, -0.5, 1e-12);
  EXPECT_NEAR(face_along(box, {0.1, 0.2, 0}, {0, 0, 1}, 9)->at.z, 0.5, 1e-12);
  EXPECT_FALSE(face_along(box, {0.1, 0.2, -3}, {0, 0, 1}, 2.49));
  EXPECT_FALSE(face_along(box, {3, 0.2, -3}, {0, 0, 1}, 9));
  EXPECT_FALSE(face_between(box, Vec3(0), Vec3(0))) << "between equal points there is none";
}

}  // namespace
}  // namespace kerf
