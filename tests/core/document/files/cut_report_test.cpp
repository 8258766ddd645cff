#include "core/document/files/cut_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

double smallest_angle_of(const Triangle& t) {
  double smallest = 180;
  for (size_t i = 0; i < 3; ++i) {
    const Vec3 a = glm::normalize(t[(i + 1) % 3] - t[i]), b = glm::normalize(t[(i + 2) % 3] - t[i]);
    smallest = std::min(smallest, std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * 180 / std::numbers::pi);
  }
  return smallest;
}

// One face anywhere among more than are measured at once is the sharpest.
TEST(SmallestAngle, is_that_of_the_sharpest_face_wherever_it_is) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world = world_of(grid(140, 1));
    Mesh& mesh = only_body(world).mesh;
    const FaceId sharp(static_cast<uint32_t>(random.below(mesh.face_slots())));
    const VertexId corner = mesh.corners(sharp)[0];
    mesh.move_vertex(corner, mesh.position(corner) + Vec3(0.0047, 0, 0.0021));
    double smallest = 180;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f)
      smallest = std::min(smallest, smallest_angle_of(mesh.triangle(FaceId(f))));
    EXPECT_LT(smallest, 40);
    EXPECT_NEAR(smallest_angle(world), smallest, 1e-6);
  }
}

}  // namespace
}  // namespace kerf::test
