#include "core/world/world.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

TEST(StateHash, does_not_depend_on_the_order_of_faces_or_corners) {
  const Soup soup = torus(9, 7, 1, 0.3);
  Soup other = soup;
  Random random(2);
  for (size_t i = other.triangles.size(); i > 1; --i)
    std::swap(other.triangles[i - 1], other.triangles[random.below(i)]);
  for (auto& t : other.triangles) t = {t[1], t[2], t[0]};
  EXPECT_EQ(state_hash(world_of(soup)), state_hash(world_of(other)));
  other.positions[3].x += 1e-15;
  EXPECT_NE(state_hash(world_of(soup)), state_hash(world_of(other)));
}

TEST(StateHash, covers_exactly_the_state_that_commands_can_change) {
  const World before = world_of(torus(9, 7, 1, 0.3));
  const uint64_t hash = state_hash(before);
  const auto after = [&](auto change) {
    World world = before;
    change(world, only_body(world));
    return state_hash(world);
  };
  EXPECT_EQ(after([](World&, Body&) {}), hash);
  EXPECT_EQ(after([](World&, Body& b) { b.name = "other"; }), hash);
  EXPECT_NE(after([](World&, Body& b) { b.mesh.remove_face(FaceId(5)); }), hash);
  EXPECT_NE(after([](World&, Body& b) { b.placement.position.x = 1e-9; }), hash);
  EXPECT_NE(after([](World&, Body& b) { b.motion.velocity.y = 1e-9; }), hash);
  EXPECT_NE(after([](World&, Body& b) { b.heat.set_energy(b.mesh, FaceId(5), 1e-9); }), hash);
  EXPECT_NE(after([](World& w, Body&) { w.pass(1); }), hash);
  EXPECT_NE(after([](World&, Body& b) { b.solid = true; }), hash);
}

}  // namespace
}  // namespace kerf::test
