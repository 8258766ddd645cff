#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/document/document.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

constexpr double kBeamRadius = 0.02;

struct Cut {
  World world;
  size_t faces_made = 0;
  std::vector<SweptCylinder> swept;

  const Mesh& mesh() { return only_body(world).mesh; }
  double distance(const Vec3& p) const {
    double least = 1e300;
    for (const SweptCylinder& part : swept) least = std::min(least, part.signed_distance(p));
    return least;
  }
};

// A stroke between two random poses above the plate or what else lies in y = 0.
Cut cut(const Soup& soup, const Resolution& resolution, uint64_t seed, bool tilt) {
  Random random(seed);
  const auto pose = [&] {
    const Vec3 direction =
        tilt ? glm::normalize(Vec3(random.uniform(-0.3, 0.3), -1, random.uniform(-0.3, 0.3)))
             : Vec3(0, -1, 0);
    return Pose{Vec3(random.uniform(-0.3, 0.3), 0, random.uniform(-0.3, 0.3)) - direction, direction};
  };
  CutSettings settings;
  settings.laser.radius = kBeamRadius;
  settings.laser.range = {0, 5};
  settings.resolution = resolution;
  const Pose from = pose(), to = pose();
  Document document(world_of(soup));
  document.apply(BeginStroke{settings, from});
  document.apply(MoveBeam{to});
  document.apply(EndStroke{});
  Cut result;
  const auto stepped = run_all(document);
  EXPECT_TRUE(stepped.ok());
  result.faces_made = stepped->statistics.faces_made;
  result.world = document.world();
  for (const BeamMove& m : subdivide({from, to}, kBeamRadius / 8, 2))
    result.swept.emplace_back(m.from, m.to, kBeamRadius, settings.laser.range);
  return result;
}

// The corners of what was taken out of the middle of a plate of edge 1.
std::vector<Vec3> rim_of_plate(const Mesh& mesh) {
  const auto inside = [](const Vec3& p) { return std::abs(p.x) < 0.49 && std::abs(p.z) < 0.49; };
  std::vector<Vec3> rim;
  std::vector<Mesh::Side> others;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    const auto corners = mesh.corners(FaceId(f));
    for (size_t i = 0; i < 3; ++i) {
      others.clear();
      mesh.append_edge_sides(FaceId(f), corners[i], corners[(i + 1) % 3], others);
      const Vec3 p = mesh.position(corners[i]);
      if (others.empty() && inside(p)) rim.push_back(p);
    }
  }
  return rim;
}

Resolution tolerance_of(Scheme scheme, double tolerance) {
  return {.scheme = scheme, .rule = Resolution::Rule::kTolerance, .tolerance = tolerance};
}

TEST(Tolerance, bounds_the_overshoot_of_the_removed_area) {
  for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
    for (uint64_t seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      const double tolerance = kBeamRadius / (seed % 2 == 0 ? 8 : 3);
      Cut c = cut(plate(1), tolerance_of(scheme, tolerance), seed, seed > 5);
      double farthest = 0;
      for (const Vec3& p : rim_of_plate(c.mesh())) farthest = std::max(farthest, c.distance(p));
      EXPECT_LE(farthest, tolerance * (seed > 5 ? 1.01 : 1.0 + 1e-9));
      EXPECT_GT(farthest, 0.3 * tolerance);  // and is made use of
      EXPECT_EQ(find_fault(c.mesh()), "");
    }
  }
}

TEST(Tolerance, needs_at_most_half_the_faces_of_the_edge_length_rule) {
  for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
    for (uint64_t seed = 1; seed <= 6; ++seed) {
      for (const double length : {kBeamRadius / 4, kBeamRadius / 8}) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", length " + std::to_string(length));
        const Resolution edges{
            .scheme = scheme, .rule = Resolution::Rule::kTargetEdge, .target_edge = length};
        const size_t by_length = cut(plate(1), edges, seed, false).faces_made;
        EXPECT_LE(2 * cut(plate(1), tolerance_of(scheme, length), seed, false).faces_made, by_length);
      }
    }
  }
}

TEST(Tolerance, leaves_faces_outside_the_beam_unchanged) {
  for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
    Cut c = cut(grid(40, 1), tolerance_of(scheme, kBeamRadius / 8), 3, false);
    const double reach = 2 * std::sqrt(2.0) / 40;  // two faces
    size_t split = 0;
    for (uint32_t f = 0; f < c.mesh().face_slots(); ++f) {
      if (!c.mesh().is_live(FaceId(f)) || c.mesh().data(FaceId(f)).halvings == 0) continue;
      ++split;
      const Triangle t = c.mesh().triangle(FaceId(f));
      EXPECT_LE(std::min({c.distance(t[0]), c.distance(t[1]), c.distance(t[2])}), reach);
    }
    EXPECT_GT(split, 50u);
  }
}

// Against the farthest of many points of the triangle from the nearest of many places of the beam.
TEST(Overshoot, is_the_distance_of_the_farthest_point) {
  Random random(8);
  for (int i = 0; i < 300; ++i) {
    const Vec3 axis = random_direction(random);
    const bool oblique = i % 3 == 0;
    const Vec3 sideways = glm::normalize(glm::cross(axis, random_direction(random)));
    const Pose from{{0, 0, 0}, axis},
        to{(oblique ? 0.3 : 0.0) * axis + random.uniform(0, 1) * sideways, axis};
    const SweptCylinder beam(from, to, 0.2, {0.5, 1.5});
    Triangle t;
    for (Vec3& p : t) p = axis + 0.8 * random_direction(random);
    double most = 0;
    for (const Vec3& p : t) {
      double least = 1e300;
      for (int s = 0; s <= 2000; ++s) {
        const Vec3 offset = p - (from.origin + s / 2000.0 * (to.origin - from.origin));
        const double depth = glm::dot(offset, axis), across = glm::length(offset - depth * axis);
        least = std::min(
            least, glm::length(Vec2(std::max(0.0, across - 0.2), std::max({0.0, 0.5 - depth, depth - 1.5}))));
      }
      most = std::max(most, least);
    }
    EXPECT_NEAR(beam.overshoot(t), most, 1e-3);
    if (beam.contains(t)) EXPECT_EQ(beam.overshoot(t), 0);
  }
}

}  // namespace
}  // namespace kerf::test
