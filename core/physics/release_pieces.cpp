#include "core/physics/release_pieces.h"

#include <algorithm>
#include <vector>

#include "core/base/assert.h"
#include "core/edit/detach.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/body_mass.h"

namespace kerf {

namespace {

// Returns the labels of a body that have faces, except the lowest of them.
std::vector<uint32_t> pieces_off(const Body& body) {
  std::vector<uint32_t> labels;
  bool first = true;
  for (uint32_t p = 0; p < body.pieces.size(); ++p) {
    if (body.pieces[p].faces == 0) continue;
    if (!first) labels.push_back(p);
    first = false;
  }
  return labels;
}

// Changes the velocity of a body as an impulse at its centre of mass does.
void push(Body& body, const Vec3& change) {
  if (!body.pinned) body.motion.velocity += change;
}

void push_apart(Body& rest, Body& piece, double metre) {
  const RigidFrame of_rest = rigid_frame(rest), of_piece = rigid_frame(piece);
  KERF_ASSERT(metre > 0);
  const double mass = of_rest.mass + of_piece.mass;
  const Vec3 way = piece.placement.to_world(of_piece.centre) - rest.placement.to_world(of_rest.centre);
  const double length = glm::length(way), size = glm::length(rest.loaded.max - rest.loaded.min);
  // Pieces around the same centre have no direction of separation.
  if (!(mass > 0) || !(length > 1e-3 * size)) return;
  const Vec3 apart = kPushApart * std::min(metre, size) / length * way;
  push(piece, of_rest.mass / mass * apart);
  push(rest, -of_piece.mass / mass * apart);
}

}  // namespace

bool has_pieces_off(const Body& body) { return !body.hidden && !pieces_off(body).empty(); }

void release_pieces(World& world, uint32_t generation, Delta& delta) {
  for (const BodyId id : world.ids()) {
    if (!has_pieces_off(world.body(id))) continue;
    update_mass_properties(world.body(id));
    for (const uint32_t label : pieces_off(world.body(id))) {
      const BodyId own = detach(world, {id, label}, generation, delta);
      Body &rest = world.body(id), &piece = world.body(own);
      piece.pinned = false;
      rest.motion.wake();
      piece.motion.wake();
      // A piece that turns on a joint was not cut off.
      if (piece.pieces[label].cut_off.faces > 0) push_apart(rest, piece, world.environment().metre);
    }
  }
}

}  // namespace kerf
