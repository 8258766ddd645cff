#include "core/tree/tree_internal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "core/tree/aabb_tree.h"
#include "tests/support/real_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

TEST(SideOf, is_exact_if_products_round_alike) {
  const double e = 0x1p-52;
  // (1 + e)^2 and 1 + 2e round to the same double.
  EXPECT_EQ(side_of({1 + e, 1 + 2 * e}, {1, 1 + e}), 1);
  EXPECT_EQ(side_of({1 + 2 * e, 1 + e}, {1 + e, 1}), -1);
  EXPECT_EQ(side_of({-1 - e, 1 + 2 * e}, {-1, 1 + e}), -1);
  EXPECT_EQ(side_of({3, 5}, {6, 10}), 0);
  EXPECT_EQ(side_of({0, 5}, {7, 0}), -1);
  EXPECT_EQ(side_of({0, 0}, {7, 1}), 0);
}

// x (y + 1) and (x + 1) y differ by x - y, which is less than half a unit of their last place.
TEST(SideOf, is_exact_for_integers_of_53_bits) {
  Random random(10);
  for (int i = 0; i < 1000; ++i) {
    const double x = std::floor(random.uniform(0x1p52, 0x1p53 - 1)),
                 y = std::floor(x - random.uniform(-0x1p50, 0x1p50));
    if (y < 0x1p52 || y > 0x1p53 - 2) continue;
    const int expected = x > y ? 1 : x < y ? -1 : 0;
    const double scale = std::ldexp(1, static_cast<int>(random.below(600)) - 300);
    EXPECT_EQ(side_of({scale * x, scale * (x + 1)}, {y, y + 1}), expected);
    EXPECT_EQ(side_of({-scale * x, scale * (x + 1)}, {-y, y + 1}), -expected);
  }
}

TEST(SideOf, is_exact_if_products_underflow_or_overflow) {
  EXPECT_EQ(side_of({1e-200, 1e-200}, {1e-200, 2e-200}), 1);
  EXPECT_EQ(side_of({1e-200, 1e-200}, {2e-200, 1e-200}), -1);
  EXPECT_EQ(side_of({1e200, 1e200}, {2e200, 1e200}), -1);
  EXPECT_EQ(side_of({5e-324, 1}, {5e-324, 1}), 0);
  EXPECT_EQ(side_of({5e-324, 0.5}, {5e-324, 0.75}), 1);
}

TEST(ShearedRay, crosses_a_triangle_at_the_same_length_in_any_orientation) {
  Random random(11);
  for (int i = 0; i < 1000; ++i) {
    const Triangle t{random_direction(random), random_direction(random), random_direction(random)};
    const Vec3 axis = random_direction(random);
    const ShearedRay ray({(t[0] + t[1] + t[2]) / 3.0 - 2.0 * axis, axis});
    const auto length = ray.cross(t);
    EXPECT_EQ(length, ray.cross({t[1], t[2], t[0]}));
    EXPECT_EQ(length, ray.cross({t[2], t[0], t[1]}));
  }
}

// A line through corners with small integer coordinates passes through the origin or farther from it than the
// displaced ray does.
TEST(ShearedRay, breaks_ties_as_if_displaced_along_one_axis_and_less_along_the_next) {
  Random random(13);
  size_t crossed = 0;
  for (int i = 0; i < 3000; ++i) {
    Triangle t;
    for (Vec3& p : t) {
      for (int k = 0; k < 3; ++k) p[k] = static_cast<double>(random.below(7)) - 3;
    }
    for (int along = 0; along < 3; ++along) {
      const int first = kNextAxis[along], second = kNextAxis[first];
      Vec3 direction(0), displaced(0);
      direction[along] = i % 2 == 0 ? 1 : -1;
      displaced[first] = 0x1p-10;
      displaced[second] = 0x1p-20;
      const bool expected = ShearedRay({displaced, direction}).cross(t).has_value();
      EXPECT_EQ(ShearedRay({Vec3(0), direction}).cross(t).has_value(), expected)
          << "triangle " << i << " of seed 13 along axis " << along;
      crossed += expected;
    }
  }
  EXPECT_GT(crossed, 100u);
}

TEST(ShearedRay, misses_a_triangle_it_sees_as_a_point) {
  const Triangle t{Vec3(1, 0, 1), Vec3(1, 3, 1), Vec3(1, 5, 1)};
  EXPECT_FALSE(ShearedRay({{0, -9, 0}, {0, 1, 0}}).cross(t));
  EXPECT_FALSE(ShearedRay({{1, -9, 1}, {0, 1, 0}}).cross(t));
}

TEST(ShearedRay, crosses_triangles_of_any_size) {
  for (const int exponent : {-480, -380, 0, 380, 480}) {
    const double unit = std::ldexp(1.0, exponent);
    const Triangle t{unit * Vec3(-1, 2, -1), unit * Vec3(3, 2, -1), unit * Vec3(-1, 2, 3)};
    const std::optional<double> length = ShearedRay({{0, -unit, 0}, {0, 1, 0}}).cross(t);
    ASSERT_TRUE(length) << exponent;
    EXPECT_EQ(*length, 3 * unit) << exponent;
  }
}

// A ray through a vertex or the middle of an edge goes in as often as out.
TEST(Crossings, of_real_closed_meshes_are_even_through_all_vertices_and_edges) {
  const auto files = real_meshes(120000);
  if (files.empty()) GTEST_SKIP() << kNoRealMeshes;
  constexpr uint32_t kMaxFaces = 12000;  // a mesh, spread over it
  Random random(12);
  size_t closed = 0;
  for (const auto& file : files) {
    World world = world_of_file(file);
    const Body& body = only_body(world);
    if (body.loaded.boundary_edges > 0 || body.loaded.non_manifold_edges > 0) continue;
    ++closed;
    const double size = glm::length(body.loaded.max - body.loaded.min);
    size_t odd = 0;
    for (uint32_t f = 0; f < body.mesh.face_slots(); f += 1 + body.mesh.face_slots() / kMaxFaces) {
      const Triangle t = body.mesh.triangle(FaceId(f));
      // Along an axis as well: there the images of many edges lie on the ray.
      Vec3 along(0);
      along[static_cast<int>(f % 3)] = 1;
      for (const Vec3& axis : {random_direction(random), along}) {
        for (const Vec3& through : {t[0], 0.5 * t[0] + 0.5 * t[1]}) {
          std::vector<RayHit> hits;
          body.tree.crossings(body.mesh, {through - 2 * size * axis, axis}, {0, 9 * size}, hits);
          odd += hits.size() % 2;
        }
      }
    }
    EXPECT_EQ(odd, 0u) << file;
  }
  EXPECT_GT(closed, 3u);
}

}  // namespace
}  // namespace kerf::test
