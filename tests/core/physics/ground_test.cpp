#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/physics/physics.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/piles.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

constexpr double kHalfTurn = 3.141592653589793;

// The height of the lowest of all vertices of the faces of a body, m.
double lowest(const Body& body) {
  double least = INFINITY;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    for (const Vec3& p : body.mesh.triangle(FaceId(f))) least = std::min(least, body.placement.to_world(p).y);
  }
  return least;
}

double lowest(const World& world) {
  double least = INFINITY;
  for (const BodyId id : world.ids()) least = std::min(least, lowest(world.body(id)));
  return least;
}

// A tube around a curve that is tied into a trefoil knot.
Soup knot(int rings, int sectors) {
  Soup soup = test::torus(rings, sectors, 1, 0.3);
  const auto curve = [](double t) {
    return Vec3(std::sin(t) + 2 * std::sin(2 * t), -std::sin(3 * t), std::cos(t) - 2 * std::cos(2 * t));
  };
  for (int r = 0; r < rings; ++r) {
    const double t = 2 * kHalfTurn * r / rings;
    const Vec3 along = glm::normalize(curve(t + 1e-4) - curve(t - 1e-4));
    const Vec3 side = glm::normalize(glm::cross(along, Vec3(0, 1, 0))), up = glm::cross(side, along);
    for (int s = 0; s < sectors; ++s) {
      const double a = 2 * kHalfTurn * s / sectors;
      soup.positions[static_cast<size_t>(r * sectors + s)] =
          curve(t) + 0.4 * (std::cos(a) * side + std::sin(a) * up);
    }
  }
  return soup;
}

// A half of a sphere without a lid.
Soup cup(int rings, int sectors) {
  Soup soup = test::sphere(rings, sectors, 1);
  std::erase_if(soup.triangles, [&](const auto& t) {
    return soup.positions[t[0]].y > 0.01 || soup.positions[t[1]].y > 0.01 || soup.positions[t[2]].y > 0.01;
  });
  return soup;
}

Soup random_mesh(Random& random) {
  switch (random.below(6)) {
    case 0:
      return test::rectangle(random.uniform(0.1, 1), random.uniform(0.1, 1), 6);
    case 1:
      return test::tube(6, 24, random.uniform(0.1, 0.5), random.uniform(0.2, 2));
    case 2:
      return knot(60, 12);
    case 3:
      return cup(12, 24);
    case 4:
      return test::both(test::closed_box({1, random.uniform(0.1, 1), 1}), test::pillow());
    default:
      return test::random_soup(60, random);
  }
}

// A mesh whose longest side is a metre.
Soup scaled_to_a_metre(const Soup& soup) {
  Box box;
  for (const auto& t : soup.triangles) {
    for (const uint32_t v : t) box.add(soup.positions[v]);
  }
  const Vec3 size = box.max - box.min, middle = 0.5 * (box.min + box.max);
  const double scale = 1 / std::max({size.x, size.y, size.z});
  return test::moved(soup, -scale * middle, scale);
}

glm::dquat turn_at_random(Random& random) {
  const auto part = [&] { return random.uniform(-1, 1); };
  const double w = part(), x = part(), y = part(), z = part();
  return glm::normalize(glm::dquat(w, x, y, z));
}

World one_above_the_other(int count, uint64_t seed) {
  Random random(seed);
  World world = test::world_with_ground();
  for (int i = 0; i < count; ++i) {
    const Soup soup = scaled_to_a_metre(random_mesh(random));
    test::add(world, soup, {random.uniform(-0.3, 0.3), 1 + 1.5 * i, random.uniform(-0.3, 0.3)},
              turn_at_random(random));
  }
  return world;
}

TEST(Ground, keeps_every_vertex_of_thirty_meshes_above_it) {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world = one_above_the_other(3, seed);
    Physics physics;
    for (Ticks t = 0; t < 4 * kTicksPerSecond; ++t) {
      physics.tick(world);
      ASSERT_GT(lowest(world), -0.001) << "at tick " << t;
    }
    EXPECT_LT(lowest(world), 0.002) << "all hang in the air";
  }
}

TEST(Ground, releases_a_sunken_body_within_a_second) {
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world = one_above_the_other(2, seed);
    const BodyId low = world.ids()[0];
    world.body(low).placement.position.y -= lowest(world.body(low)) + 0.3;
    Physics physics;
    for (Ticks t = 0; t < kTicksPerSecond; ++t) physics.tick(world);
    EXPECT_GT(lowest(world), -0.001);
  }
}

TEST(Ground, supports_a_mesh_with_doubled_sheets) {
  World world = test::world_with_ground();
  Soup box = test::closed_box({0.5, 0.5, 0.5});
  const std::vector<std::array<uint32_t, 3>> once(box.triangles.begin(), box.triangles.end());
  box.triangles.insert(box.triangles.end(), once.begin(), once.end());
  test::add(world, box, {0, 0.5, 0});
  test::let_move(world, 1);
  EXPECT_GT(lowest(world), -0.001);
}

TEST(Ground, with_piles_is_the_same_for_any_thread_count) {
  std::vector<uint64_t> hashes;
  for (const size_t threads : {1u, 2u, 16u}) {
    const ThreadLimit limit(threads);
    World world = test::rain(40, 3, 0.4);
    test::let_move(world, 1.5);
    hashes.push_back(state_hash(world));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

}  // namespace
}  // namespace kerf
