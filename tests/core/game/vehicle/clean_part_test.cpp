#include "core/game/vehicle/vehicle.h"

#include <gtest/gtest.h>

#include "tests/support/game_files.h"

namespace kerf {
namespace {

TEST(CleanPart, a_wheel_is_clean_until_a_beam_cuts_through_it) {
  test::LoneVehicle lone;
  const BodyId wheel = lone.vehicle.wheels[0].body;
  const Body& loaded = lone.vehicle.model->wheels[0].body;
  EXPECT_TRUE(is_clean(lone.world.body(wheel), loaded));
  const Vec3 hub = lone.vehicle.what().wheels[0].hub;
  const double out = hub.x > 0 ? 1 : -1;
  const Vec3 from(hub.x + 2 * out, 0, hub.z + 0.02);
  lone.cut({from + Vec3(0, -0.2, 0), {-out, 0, 0}}, {from + Vec3(0, 1, 0), {-out, 0, 0}}, 0.02, 3);
  size_t pieces = 0;
  for (const BodyId id : lone.world.ids()) {
    const Body& body = lone.world.body(id);
    if (body.loaded_as != wheel) continue;
    ++pieces;
    EXPECT_FALSE(is_clean(body, loaded));
  }
  EXPECT_GE(pieces, 2u);
}

TEST(CleanPart, a_tiny_remnant_is_not_clean) {
  test::LoneVehicle lone;
  Body& wheel = lone.world.body(lone.vehicle.wheels[0].body);
  for (uint32_t f = 3; f < wheel.mesh.face_slots(); ++f) {
    if (wheel.mesh.is_live(FaceId(f))) wheel.mesh.remove_face(FaceId(f));
  }
  EXPECT_FALSE(is_clean(wheel, lone.vehicle.model->wheels[0].body));
}

}  // namespace
}  // namespace kerf
