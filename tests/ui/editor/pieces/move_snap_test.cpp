#include "ui/editor/pieces/piece_placement.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"
#include "ui/editor/shared/viewport.h"

namespace kerf {
namespace {

class VertexNear : public testing::Test {
 protected:
  VertexNear() {
    view.camera.look({0.3, 5, 0.1}, {0, 0, 0});
    view.camera.finish();
    view.layout = lay_out({1000, 700}, 16, 26, 26);
  }
  Vec2 place_of(const Vec3& p) const { return *PrimaryViewport(view).place_of(p); }

  World world = test::world_of(test::grid(2, 2));  // vertices at whole metres, in y = 0
  ViewState view;
  const PieceId nothing{{7, 0}, 0};
};

TEST_F(VertexNear, is_found_near_the_pointer_and_not_inside_a_face) {
  const Vec3 vertex = world.body(world.ids()[0]).mesh.triangle(FaceId(0))[0];
  const Vec3 inside = vertex * 0.99;
  const auto near = vertex_near(world, view, place_of(inside), nothing);
  ASSERT_TRUE(near.has_value());
  EXPECT_LT(glm::length(*near - vertex), 1e-12);
  const Triangle t = world.body(world.ids()[0]).mesh.triangle(FaceId(0));
  EXPECT_FALSE(vertex_near(world, view, place_of((t[0] + t[1] + t[2]) / 3.0), nothing).has_value());
}

TEST_F(VertexNear, excludes_the_moved_piece) {
  const Vec3 inside = world.body(world.ids()[0]).mesh.triangle(FaceId(0))[0] * 0.99;
  EXPECT_FALSE(vertex_near(world, view, place_of(inside), {world.ids()[0], 0}).has_value());
}

TEST(SnapStep, is_a_round_length_in_the_unit) {
  EXPECT_EQ(snap_step(FileUnit::kMetre), 0.01);
  EXPECT_EQ(snap_step(FileUnit::kCentimetre), 1);
  EXPECT_EQ(snap_step(FileUnit::kMillimetre), 1);
  EXPECT_EQ(snap_step(FileUnit::kInch), 0.1);
}

}  // namespace
}  // namespace kerf
