#include <gtest/gtest.h>

#include <algorithm>

#include "core/cut/cut_step.h"
#include "core/document/document.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/runs.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

constexpr double kSize = 1;  // of each body, m

// How deep within the beam the middle of a face may lie that is left, in radii. A volume that tilts is known
// less exactly (see SweptCylinder).
constexpr double kMost = 0.01, kMaxTilting = 0.05;

struct Slit {
  CutSettings settings;
  Pose from, to;
};

// A stroke through the bodies around the origin, of any length; now and then the beam tilts on the way.
Slit random_slit(Random& random, const CutSettings& settings) {
  const Vec3 axis = random_direction(random);
  const Vec3 along = glm::normalize(glm::cross(axis, random_direction(random)));
  const Vec3 middle = 0.2 * kSize * random_direction(random) - 2 * kSize * axis;
  const double half = (random.below(2) == 0 ? 0.2 : 0.8) * kSize;
  const Vec3 last_axis = random.below(3) == 0 ? glm::normalize(axis + 0.15 * along) : axis;
  return {settings, {middle - half * along, axis}, {middle + half * along, last_axis}};
}

// Radius and resolution relative to the faces differ widely: from faces much larger than the beam to much
// smaller ones.
CutSettings random_settings(Random& random, Scheme scheme) {
  constexpr std::array kRadii{0.006, 0.012, 0.03};
  CutSettings settings;
  settings.laser.radius = kSize * kRadii[random.below(kRadii.size())];
  settings.laser.range = {0, 4 * kSize};
  settings.resolution.target_edge = kSize / (random.below(2) == 0 ? 30 : 80);
  settings.resolution.scheme = scheme;
  settings.resolution.rim = Rim::kSmooth;
  return settings;
}

Soup random_shape(Random& random) {
  switch (random.below(4)) {
    case 0:
      return sphere(5 + static_cast<int>(random.below(12)), 5 + static_cast<int>(random.below(16)), 0.5);
    case 1:
      return torus(5 + static_cast<int>(random.below(12)), 4 + static_cast<int>(random.below(8)), 0.35, 0.15);
    case 2:
      return tube(1 + static_cast<int>(random.below(4)), 5 + static_cast<int>(random.below(12)), 0.3, 0.9);
    default:
      return random_soup(40, random);
  }
}

Placement random_placement(Random& random) {
  const Vec3 shift = 0.1 * kSize * random_direction(random);
  const Vec3 axis = random_direction(random);
  return {shift, glm::normalize(glm::dquat(random.uniform(-1, 1), axis.x, axis.y, axis.z))};
}

// One body where it was loaded, one that was moved and one that is hidden, all through one another.
World random_world(Random& random) {
  World world;
  for (const char* name : {"loaded", "moved", "hidden"})
    world.add(make_body(name, build(random_shape(random))));
  const auto ids = world.ids();
  world.body(ids[1]).placement = random_placement(random);
  world.body(ids[2]).hidden = true;
  return world;
}

// The moves of the beam, as they were walked.
std::vector<BeamMove> draw(Document& document, const Slit& slit) {
  document.apply(BeginStroke{slit.settings, slit.from});
  document.apply(MoveBeam{slit.to});
  document.apply(EndStroke{});
  std::vector<BeamMove> moves;
  while (document.waiting() > 0) {
    if (const auto move = document.queue().pending().next_move(document.world())) moves.push_back(*move);
    EXPECT_TRUE(document.step(1).ok());
  }
  return moves;
}

// How deep inside one of the volumes that the beam has swept the middle of a face lies that is left, over the
// radius; zero where nothing was left standing.
double deepest_face(const Body& body, const Laser& laser, const std::vector<BeamMove>& moves) {
  const Placement& placement = body.placement;
  std::vector<SweptCylinder> swept;
  for (const BeamMove& move : moves)
    swept.emplace_back(placement.to_body(move.from), placement.to_body(move.to), laser.radius, laser.range);
  double least = 0;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
    for (const SweptCylinder& part : swept) least = std::min(least, part.signed_distance(middle));
  }
  return -least / laser.radius;
}

void expect_clean_slits(uint64_t seed, Scheme scheme) {
  SCOPED_TRACE("seed " + std::to_string(seed) +
               (scheme == Scheme::kOneToFour ? ", one-to-four" : ", longest-edge"));
  Random random(seed);
  Document document(random_world(random));
  const World before = document.world();
  const CutSettings settings = random_settings(random, scheme);
  std::vector<std::vector<BeamMove>> strokes;
  for (size_t n = 1 + random.below(3); n > 0; --n)
    strokes.push_back(draw(document, random_slit(random, settings)));
  for (const BodyId id : cuttable(document.world())) {
    const Body& body = document.world().body(id);
    SCOPED_TRACE(body.name);
    EXPECT_EQ(find_fault(body.mesh, true), "");
    for (const auto& moves : strokes) {
      const bool tilts = moves.front().from.direction != moves.back().to.direction;
      EXPECT_LE(deepest_face(body, settings.laser, moves), tilts ? kMaxTilting : kMost);
    }
  }
  const BodyId hidden = before.ids()[2];
  expect_same_body(document.world().body(hidden), before.body(hidden));
}

TEST(SmoothRim, leaves_no_face_inside_slits_through_moved_and_hidden_bodies) {
  for (uint64_t seed = 1; seed <= runs(30); ++seed) {
    for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) expect_clean_slits(seed, scheme);
  }
}

}  // namespace
}  // namespace kerf::test
