#include "ui/render/corner_heat.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

double kelvin(uint16_t mark) { return mark == 0 ? kAmbient : mark * kHeatUnit; }

// Gives the face this temperature (K), below the transition.
void heat_to(Body& body, FaceId f, double temperature) {
  const Substance& s = body.sheet.substance;
  const double mass = triangle_area(body.mesh.triangle(f)) * body.sheet.thickness * s.density;
  body.heat.set_energy(body.mesh, f, mass * enthalpy_at(s, temperature));
  body.heat.note_hottest(body.mesh, f, temperature);
}

TEST(CornerHeat, of_a_body_that_was_never_hot_is_none) {
  const Body body = make_body("grid", test::build(test::grid(8, 1)));
  CornerHeat heat;
  std::vector<FaceId> affected;
  heat.update(body, {}, affected);
  EXPECT_FALSE(heat.any());
  EXPECT_TRUE(affected.empty());
}

TEST(CornerHeat, is_the_mean_of_the_faces_around_a_corner) {
  Body body = make_body("grid", test::build(test::grid(8, 1)));
  const FaceId hot(40);
  heat_to(body, hot, 1200);
  CornerHeat heat;
  std::vector<FaceId> affected;
  heat.update(body, {}, affected);
  EXPECT_NEAR(heat.warmest(), 1200, 1e-6);
  Mesh::Star star;
  for (size_t i = 0; i < 3; ++i) {
    body.mesh.star(body.mesh.corners(hot)[i], star);
    const auto around = static_cast<double>(star.faces.size());
    const HeatMark mark = heat.of(body.mesh, hot)[i];
    EXPECT_NEAR(kelvin(mark.now), kAmbient + (1200 - kAmbient) / around, kHeatUnit);
    EXPECT_EQ(mark.hottest, mark.now);
    for (const FaceId f : star.faces)
      EXPECT_NE(std::find(affected.begin(), affected.end(), f), affected.end()) << f.index;
  }
}

TEST(CornerHeat, of_faces_that_cooled_down_leaves_the_tint_until_that_is_undone) {
  Body body = make_body("grid", test::build(test::grid(8, 1)));
  const FaceId hot(40);
  heat_to(body, hot, 1200);
  CornerHeat heat;
  std::vector<FaceId> affected;
  heat.update(body, {}, affected);
  body.heat.set_energy(body.mesh, hot, 0);
  heat.update(body, {}, affected);
  EXPECT_EQ(heat.of(body.mesh, hot)[0].now, 0);
  EXPECT_GT(heat.of(body.mesh, hot)[0].hottest, 0);
  body.mesh.columns().set(body.heat.hottest, hot, 0.0f);
  heat.update(body, {}, affected);
  EXPECT_EQ(heat.of(body.mesh, hot)[0], HeatMark());
}

// What follows from change to change must be what a look at the whole body finds.
TEST(CornerHeat, follows_heat_and_removals_like_one_that_begins_anew) {
  Random random(11);
  Body body = make_body("grid", test::build(test::grid(12, 1)));
  CornerHeat followed;
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    std::vector<VertexId> changed;
    for (int i = 0; i < 6; ++i) {
      const FaceId f(static_cast<uint32_t>(random.below(body.mesh.face_slots())));
      if (!body.mesh.is_live(f)) continue;
      const size_t what = random.below(4);
      if (what == 0) {
        const auto corners = body.mesh.corners(f);
        changed.insert(changed.end(), corners.begin(), corners.end());
        body.mesh.remove_face(f);
      } else if (what == 1) {
        body.heat.set_energy(body.mesh, f, 0);
      } else {
        heat_to(body, f, random.uniform(300, 1700));
      }
    }
    std::vector<FaceId> affected;
    followed.update(body, changed, affected);
    CornerHeat anew;
    anew.update(body, {}, affected);
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      ASSERT_EQ(followed.of(body.mesh, FaceId(f)), anew.of(body.mesh, FaceId(f))) << f;
    }
  }
}

}  // namespace
}  // namespace kerf
