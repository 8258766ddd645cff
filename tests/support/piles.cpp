#include "tests/support/piles.h"

#include "core/base/ids.h"
#include "core/base/random.h"
#include "core/cut/cut_step.h"
#include "core/edit/detach.h"
#include "core/edit/separation.h"
#include "core/physics/contact/collider.h"
#include "core/physics/physics.h"
#include "core/world/body_creation.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"

namespace kerf::test {

namespace {

Soup random_scrap(Random& random) {
  switch (random.below(4)) {
    case 0: {
      const double width = random.uniform(0.2, 0.6);
      return rectangle(width, random.uniform(0.1, 0.5), 12);
    }
    case 1:
      return disc(random.uniform(0.1, 0.3), 64);
    case 2: {
      const double radius = random.uniform(0.05, 0.15);
      return tube(8, 32, radius, random.uniform(0.2, 0.6));
    }
    default:
      return plate_with_hole(random.uniform(0.3, 0.6), 0.08, 48);
  }
}

glm::dquat random_turn(Random& random) {
  double c[4];
  for (double& x : c) x = random.uniform(-1, 1);
  return glm::normalize(glm::dquat(c[0], c[1], c[2], c[3]));
}

// Cuts along a plane across an axis: the beam looks along `beam` and moves along the third axis.
void cut_plane(World& world, int across, int beam, double at) {
  const World::Bounds bounds = world.bounds();
  const int along = 3 - across - beam;
  BeamMove move;
  move.from.direction = Vec3(0);
  move.from.direction[beam] = 1;
  move.from.origin[across] = at;
  move.from.origin[beam] = bounds.min[beam] - 0.5;
  move.to = move.from;
  move.from.origin[along] = bounds.min[along] - 0.1;
  move.to.origin[along] = bounds.max[along] + 0.1;
  CutSettings settings;
  settings.laser.radius = 0.003;
  settings.resolution.target_edge = 0.012;
  const std::vector<BeamMove> moves = subdivide(move, settings.laser.radius, settings.laser.range.high);
  UnfinishedMove unfinished;
  for (size_t done = 0; done < moves.size();) {
    const auto result = cut_step(world, settings, std::span(moves).subspan(done), unfinished);
    if (!result) return;
    done += result->moves;
  }
}

void detach_pieces(World& world, size_t least_faces) {
  const BodyId whole = world.ids().front();
  std::vector<uint32_t> labels;
  for (uint32_t label = 0; label < world.body(whole).pieces.size(); ++label) {
    if (world.body(whole).pieces[label].faces > 0) labels.push_back(label);
  }
  for (uint32_t label : labels) {
    if (is_only_piece(world, {whole, label})) break;
    Delta delta;
    detach(world, {whole, label}, 1, delta);
  }
  for (BodyId id : world.ids()) {
    if (world.body(id).mesh.live_faces() < least_faces) world.remove(id);
  }
}

// Whether balls around two bodies overlap.
bool are_near(const Body& a, const Body& b) {
  const auto middle = [](const Body& body) {
    const Bounds box = body.bounds();
    return body.placement.to_world(0.5 * (box.min + box.max));
  };
  const auto radius = [](const Body& body) {
    return 0.5 * glm::length(body.bounds().max - body.bounds().min);
  };
  return glm::length(middle(a) - middle(b)) <= radius(a) + radius(b);
}

Box box_of(const Triangle& t) {
  Box box;
  for (int i = 0; i < 3; ++i) box.add(t[i]);
  return box;
}

// Whether an edge of `edges` crosses a face of `faces`.
bool crosses(const Body& edges, const Body& faces) {
  const Bounds box = faces.bounds();
  for (uint32_t slot = 0; slot < edges.mesh.face_slots(); ++slot) {
    if (!edges.mesh.is_live(FaceId(slot))) continue;
    Triangle t = edges.mesh.triangle(FaceId(slot));
    for (int i = 0; i < 3; ++i) t[i] = faces.placement.to_body(edges.placement.to_world(t[i]));
    if (!Box{box.min, box.max}.overlaps(box_of(t))) continue;
    for (int i = 0; i < 3; ++i) {
      const Vec3 way = t[(i + 1) % 3] - t[i];
      const double length = glm::length(way);
      if (length > 0 && faces.tree.nearest(faces.mesh, Pose{t[i], way / length}, {0, length})) return true;
    }
  }
  return false;
}

}  // namespace

World world_with_ground() {
  World world;
  world.set_environment({.gravity = {0, -9.81, 0}, .ground = 0});
  return world;
}

void let_move(World& world, double seconds) {
  Physics physics;
  for (int i = 0; i < seconds * static_cast<double>(kTicksPerSecond); ++i) physics.tick(world);
}

World rain(uint64_t count, uint64_t seed, double half_width) {
  Random random(seed);
  World world = world_with_ground();
  for (uint64_t i = 0; i < count; ++i) {
    const Soup soup = random_scrap(random);
    const glm::dquat turn = random_turn(random);
    const double x = random.uniform(-half_width, half_width), z = random.uniform(-half_width, half_width);
    add(world, soup, {x, 0.5 + 0.12 * static_cast<double>(i), z}, turn);
  }
  return world;
}

World cut_to_pieces(const char* file, int planes, uint64_t seed, size_t least_faces) {
  World world = world_with_ground();
  Result<Body> body = load_body("whole", file, nullptr);
  if (!body) return world;
  world.add(std::move(*body));
  Random random(seed);
  const World::Bounds bounds = world.bounds();
  for (int across = 0; across < 3; ++across) {
    for (int i = 0; i < planes; ++i) {
      const double share = (i + random.uniform(0.2, 0.8)) / planes;
      cut_plane(world, across, across == 1 ? 0 : 1, glm::mix(bounds.min[across], bounds.max[across], share));
    }
  }
  settle(world.body(world.ids().front()));
  detach_pieces(world, least_faces);
  return world;
}

bool intersect(const Body& a, const Body& b) { return are_near(a, b) && (crosses(a, b) || crosses(b, a)); }

}  // namespace kerf::test
