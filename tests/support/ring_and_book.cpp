#include "tests/support/ring_and_book.h"

#include <glm/geometric.hpp>

#include "core/world/body_mass.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {

World ring_and_book(bool solid) {
  World world;
  const BodyId ring = world.add(make_body("torus", build(torus(16, 10, 0.5, 0.2))));
  if (solid) make_solid(world.body(ring), true);
  world.add(make_body("book", build(moved(book(5), {0.3, 0.1, 0}, 0.6))));
  world.set_environment({.gravity = {0, -9.81, 0}, .ground = -0.5});
  return world;
}

std::vector<Command> random_stroke_commands(Random& random, Beam beam) {
  CutSettings s;
  s.laser.radius = random.uniform(0.01, 0.05);
  s.laser.range = {0, 5};
  s.resolution.scheme = random.below(2) == 0 ? Scheme::kOneToFour : Scheme::kLongestEdge;
  s.resolution.rim = beam == Beam::kStraight || random.below(3) == 0 ? Rim::kSmooth : Rim::kFaces;
  s.resolution.target_edge = s.laser.radius * random.uniform(0.5, 2);
  if (random.below(2) == 0) s.faces_per_step = 1 + random.below(200);
  if (random.below(2) == 0) s.heat_width = 2 * s.laser.radius;
  const auto ahead = [&] {
    return glm::normalize(Vec3(random.uniform(-0.2, 0.2), -1, random.uniform(-0.2, 0.2)));
  };
  const Vec3 first = ahead();
  const auto pose = [&] {
    const Vec3 d = beam == Beam::kTurning ? ahead() : first;
    return Pose{Vec3(random.uniform(-0.9, 0.9), 0, random.uniform(-0.9, 0.9)) - 2.0 * d, d};
  };
  std::vector<Command> commands{BeginStroke{s, pose()}};
  for (size_t n = random.below(3) + 1; n > 0; --n) commands.emplace_back(MoveBeam{pose()});
  commands.emplace_back(EndStroke{});
  return commands;
}

}  // namespace kerf::test
