#include <gtest/gtest.h>

#include "tests/support/runs.h"
#include "tests/support/solids.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

void draw(Document& document, const SolidStroke& stroke) {
  document.apply(BeginStroke{stroke.settings, stroke.poses[0]});
  for (size_t i = 1; i < stroke.poses.size(); ++i) document.apply(MoveBeam{stroke.poses[i]});
  document.apply(EndStroke{});
  ASSERT_TRUE(run_all(document).ok());
}

// A beam that turns about a point outside.
SolidStroke turning_stroke(const World& world, Random& random) {
  const World::Bounds bounds = world.bounds();
  const double size = bounds.diagonal();
  const Vec3 axis = random_direction(random), middle = 0.5 * (bounds.min + bounds.max);
  SolidStroke stroke = straight_stroke({}, {}, axis, size * random.uniform(0.003, 0.03), {0, 4 * size});
  stroke.settings.resolution.target_edge = 0.25 * stroke.settings.laser.radius;
  const Vec3 from = middle - size * random.uniform(1, 2) * axis;
  for (Pose& pose : stroke.poses)
    pose = {from, glm::normalize(middle + 0.4 * size * random_direction(random) - from)};
  return stroke;
}

TEST(ClipAtRim, creates_no_edge_shorter_than_the_tolerance_of_the_rim) {
  const std::vector<NamedSoup> solids = generated_solids();
  for (uint64_t seed = 41; seed <= 40 + runs(80); ++seed) {
    const auto& [name, soup] = solids[seed % solids.size()];
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    Random random(seed);
    Document document(world_of(soup));
    for (int i = 0; i < 3; ++i) {
      const SolidStroke stroke = turning_stroke(document.world(), random);
      ASSERT_NO_FATAL_FAILURE(draw(document, stroke));
      const Body& body = document.world().body(document.world().ids().front());
      const double least = 1e-9 * stroke.settings.laser.radius;
      for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
        if (!body.mesh.is_live(FaceId(f))) continue;
        const Triangle t = body.mesh.triangle(FaceId(f));
        for (int k = 0; k < 3; ++k) ASSERT_GT(glm::length(t[k] - t[(k + 1) % 3]), least);
      }
    }
  }
}

}  // namespace
}  // namespace kerf::test
