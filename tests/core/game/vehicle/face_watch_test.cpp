#include "core/game/vehicle/vehicle_model.h"

#include <gtest/gtest.h>

#include <array>

#include "core/base/deterministic_math.h"
#include "core/edit/body_edit.h"
#include "tests/support/jointed.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// Three sheets beside each other: two of a door and one of a hub, a square metre each.
class FaceWatchTest : public testing::Test {
 protected:
  FaceWatchTest() {
    const std::array sheets{test::NamedSheet{"door_front", test::rectangle(1, 1, 10)},
                            test::NamedSheet{"door_rear", test::rectangle(1, 1, 10), {2, 0, 0}},
                            test::NamedSheet{"hub", test::rectangle(1, 1, 10), {4, 0, 0}}};
    body_ = make_body("sheets", test::build(test::assembled(sheets)));
    watch_ = FaceWatch(body_);
  }
  // Removes what lies beyond x.
  void remove_beyond(double x) {
    std::vector<FaceId> removed;
    for (uint32_t f = 0; f < body_.mesh.face_slots(); ++f) {
      if (body_.mesh.is_live(FaceId(f)) && body_.mesh.triangle(FaceId(f))[0].x > x) removed.emplace_back(f);
    }
    BodyEdit(body_).remove(removed);
  }

  Body body_;
  FaceWatch watch_;
};

TEST_F(FaceWatchTest, sums_the_area_of_all_groups_with_the_part_name_as_prefix) {
  const size_t door = watch_.add_part(body_, "door"), front = watch_.add_part(body_, "door_front"),
               none = watch_.add_part(body_, "window");
  EXPECT_EQ(watch_.size(), 3u);
  EXPECT_NEAR(watch_.area(door), 2, 1e-9);
  EXPECT_NEAR(watch_.area(front), 1, 1e-9);
  EXPECT_EQ(watch_.area(none), 0);
  const std::vector<double> areas = watch_.areas_in(body_);
  EXPECT_NEAR(areas[door], 2, 1e-9);
  EXPECT_NEAR(areas[front], 1, 1e-9);
}

TEST_F(FaceWatchTest, reports_the_area_left_after_removals) {
  const size_t door = watch_.add_part(body_, "door"), front = watch_.add_part(body_, "door_front"),
               hub = watch_.add_part(body_, "hub");
  remove_beyond(1.99);
  const std::vector<double> areas = watch_.areas_in(body_);
  EXPECT_NEAR(areas[door], 1.5, 0.06);
  EXPECT_NEAR(areas[front], 1, 1e-9);
  EXPECT_EQ(areas[hub], 0);
  EXPECT_NEAR(watch_.area(door), 2, 1e-9) << "as loaded";
}

TEST_F(FaceWatchTest, near_a_point_covers_ten_centimetres_beyond_the_nearest_face) {
  const size_t seat = watch_.add_part_near(body_, "door", {0, 0.2, 0});
  const double radius = 0.3, disc = kPi * (radius * radius - 0.2 * 0.2);
  EXPECT_NEAR(watch_.area(seat), disc, 0.25 * disc);
  remove_beyond(0.4);
  EXPECT_NEAR(watch_.areas_in(body_)[seat], watch_.area(seat), 1e-9) << "what has gone lies beyond";
  remove_beyond(-1);
  EXPECT_EQ(watch_.areas_in(body_)[seat], 0);
}

TEST_F(FaceWatchTest, follows_faces_that_are_split) {
  const size_t hub = watch_.add_part(body_, "hub");
  for (uint32_t f = 0; f < 600; f += 3) {
    if (!body_.mesh.is_live(FaceId(f))) continue;
    const auto c = body_.mesh.corners(FaceId(f));
    std::vector<Mesh::FaceSplit> splits;
    BodyEdit(body_).split_edge_at(FaceId(f), c[0], c[1],
                                  0.5 * body_.mesh.position(c[0]) + 0.5 * body_.mesh.position(c[1]), splits);
  }
  EXPECT_NEAR(watch_.areas_in(body_)[hub], 1, 1e-9);
}

}  // namespace
}  // namespace kerf
