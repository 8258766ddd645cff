#include "ui/render/bodies/body_picture.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

// Two squares of size 1 over each other in y = 0 and y = 1, as pieces 0 and 1 of one body.
World two_plates() {
  Body body =
      make_body("plates", test::build(test::both(test::plate(1), test::moved(test::plate(1), {0, 1, 0}, 1))));
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    body.mesh.edit_data(FaceId(f)).piece = body.mesh.triangle(FaceId(f))[0].y > 0.5 ? 1 : 0;
  }
  World world;
  world.add(std::move(body));
  return world;
}

Vec3 middle_of_first(const World& world) {
  const Triangle t = world.body(world.ids().front()).mesh.triangle(FaceId(0));
  return (t[0] + t[1] + t[2]) / 3.0;
}

Pose down_at(const Vec3& p) { return {{p.x, 3, p.z}, {0, -1, 0}}; }

TEST(Pick, hits_the_nearest_face) {
  const World world = two_plates();
  const auto met = pick(world, {}, down_at(middle_of_first(world)));
  ASSERT_TRUE(met);
  EXPECT_DOUBLE_EQ(met->length, 2);
  EXPECT_EQ(world.body(met->body).mesh.data(met->face).piece, 1u);
}

TEST(Pick, ignores_hidden_pieces) {
  const World world = two_plates();
  ViewOptions options;
  options.pieces[{world.ids().front(), 1}].hidden = true;
  const auto met = pick(world, options, down_at(middle_of_first(world)));
  ASSERT_TRUE(met);
  EXPECT_DOUBLE_EQ(met->length, 3);
}

TEST(Pick, ignores_hidden_bodies) {
  World world = two_plates();
  const Pose ray = down_at(middle_of_first(world));
  world.body(world.ids().front()).hidden = true;
  EXPECT_FALSE(pick(world, {}, ray));
}

TEST(Pick, hits_a_moved_piece_where_it_is_drawn) {
  const World world = two_plates();
  const Vec3 at = middle_of_first(world);
  ViewOptions options;
  options.pieces[{world.ids().front(), 1}].offset = {5, 0.5, 0};
  EXPECT_DOUBLE_EQ(pick(world, options, down_at(at)).value().length, 3);
  EXPECT_DOUBLE_EQ(pick(world, options, down_at(at + Vec3(5, 0, 0))).value().length, 1.5);
}

TEST(Pick, ignores_culled_back_faces) {
  const World world = two_plates();
  const Vec3 at = middle_of_first(world);
  ViewOptions options;
  options.cull_backs = true;
  const bool from_above = pick(world, options, down_at(at)).has_value();
  const bool from_below = pick(world, options, {{at.x, -3, at.z}, {0, 1, 0}}).has_value();
  EXPECT_NE(from_above, from_below);
}

TEST(Pick, ignores_parts_clipped_by_the_section_plane) {
  const World world = two_plates();
  const Vec3 at = middle_of_first(world);
  ViewOptions options;
  options.section = SectionPlane{{0, 0.5, 0}, {0, 1, 0}};
  EXPECT_DOUBLE_EQ(pick(world, options, down_at(at)).value().length, 2) << "it is not shown";
  options.show.section = true;
  EXPECT_DOUBLE_EQ(pick(world, options, down_at(at)).value().length, 3);
  options.section->normal = {0, -1, 0};
  EXPECT_DOUBLE_EQ(pick(world, options, down_at(at)).value().length, 2);
  EXPECT_DOUBLE_EQ(pick(world, options, {{at.x, -3, at.z}, {0, 1, 0}}).value().length, 4);
  options.section->point.y = 7;
  EXPECT_FALSE(pick(world, options, down_at(at)));
}

TEST(Pick, misses_empty_space) {
  EXPECT_FALSE(pick(two_plates(), {}, down_at({50, 0, 0})));
  EXPECT_FALSE(pick(World{}, {}, down_at({0, 0, 0})));
}

}  // namespace
}  // namespace kerf
