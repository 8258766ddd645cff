#include "ui/editor/pieces/area_selection.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

using test::moved;

// Three bodies in a row: spheres of radius 0.5 at x = -2, 0 and 2.
World three_spheres() {
  World world;
  for (const double x : {-2.0, 0.0, 2.0})
    world.add(make_body("sphere", test::build(moved(test::sphere(8, 12, 0.5), {x, 0, 0}, 1))));
  return world;
}

const CameraView kView = look_at({0, 0, 10}, {0, 0, 0}, 1.5);

size_t selected(const World& world, Vec2 from, Vec2 to, const ViewOptions& look = {}) {
  return pieces_in({from, to}, world, look, kView).size();
}

Vec2 seen(const Vec3& p) { return Vec2(kView.project(p)); }

TEST(RubberBand, left_to_right_selects_enclosed_pieces) {
  const World world = three_spheres();
  EXPECT_EQ(selected(world, seen({-2.7, -0.7, 0}), seen({0.7, 0.7, 0})), 2u);
  EXPECT_EQ(selected(world, seen({-2.7, -0.7, 0}), seen({0.2, 0.7, 0})), 1u);
  EXPECT_EQ(selected(world, seen({-0.1, -0.1, 0}), seen({0.1, 0.1, 0})), 0u);
}

TEST(RubberBand, right_to_left_selects_touched_pieces) {
  const World world = three_spheres();
  EXPECT_EQ(selected(world, seen({0.2, 0.7, 0}), seen({-2.7, -0.7, 0})), 2u);
  // Within a face.
  EXPECT_EQ(selected(world, seen({0.01, 0.012, 0.5}), seen({0.005, 0.01, 0.5})), 1u);
  EXPECT_EQ(selected(world, seen({1.2, 0.7, 0}), seen({0.7, -0.7, 0})), 0u);
}

TEST(RubberBand, tests_pieces_at_their_drawn_position_and_skips_hidden_ones) {
  const World world = three_spheres();
  const PieceId middle{world.ids()[1], 0};
  const Vec2 low = seen({-0.7, -0.7, 0}), high = seen({0.7, 0.7, 0});
  ViewOptions look;
  look.pieces[middle].offset = {0, 3, 0};
  EXPECT_EQ(selected(world, low, high, look), 0u);
  EXPECT_EQ(selected(world, seen({-0.7, 2.3, 0}), seen({0.7, 3.7, 0}), look), 1u);
  look.pieces[middle] = {.hidden = true};
  EXPECT_EQ(selected(world, low, high, look), 0u);
}

TEST(RubberBand, ignores_faces_that_the_section_plane_removes) {
  const World world = three_spheres();
  ViewOptions look;
  look.show.section = true;
  look.section = SectionPlane{{-0.1, 0, 0}, {1, 0, 0}};
  const Vec2 low = seen({-2.7, -0.7, 0}), high = seen({2.7, 0.7, 0});
  EXPECT_EQ(selected(world, low, high, look), 2u);
  EXPECT_EQ(selected(world, high, low, look), 2u);
  EXPECT_EQ(selected(world, low, seen({0.2, 0.7, 0}), look), 2u) << "the rest of the middle sphere is inside";
  look.show.section = false;
  EXPECT_EQ(selected(world, low, high, look), 3u);
}

// Against points of the face, which lie closer together than the margin.
TEST(RubberBand, touches_a_triangle_only_if_they_share_a_point) {
  constexpr int kSamples = 200;
  constexpr double kMargin = 0.02;
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto point = [&] { return Vec3(random.uniform(-3, 3), random.uniform(-2, 2), 0); };
    Soup soup;
    soup.positions = {point(), point(), point()};
    soup.triangles.push_back({0, 1, 2});
    World world;
    world.add(make_body("triangle", test::build(soup)));
    const Vec2 a = seen(point()), b = seen(point());
    const Vec2 low = glm::min(a, b), high = glm::max(a, b);
    bool common = false, near = false;
    for (int i = 0; i <= kSamples; ++i) {
      for (int j = 0; i + j <= kSamples; ++j) {
        const Vec3 sum = soup.positions[0] * double(i) + soup.positions[1] * double(j) +
                         soup.positions[2] * double(kSamples - i - j);
        const Vec2 at = seen(sum / double(kSamples));
        const auto within = [&](double margin) {
          return at.x >= low.x - margin && at.y >= low.y - margin && at.x <= high.x + margin &&
                 at.y <= high.y + margin;
        };
        common = common || within(0);
        near = near || within(kMargin);
      }
    }
    const bool touched = selected(world, high, low) == 1;
    if (common) {
      EXPECT_TRUE(touched);
    }
    if (!near) {
      EXPECT_FALSE(touched);
    }
  }
}

}  // namespace
}  // namespace kerf
