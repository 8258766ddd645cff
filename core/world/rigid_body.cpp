#include "core/world/rigid_body.h"

#include "core/world/world.h"

namespace kerf {

std::vector<BodyState> moved_bodies(const World& world) {
  std::vector<BodyState> states;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.motion != Motion{}) states.push_back({id, body.placement, body.motion});
  }
  return states;
}

std::vector<NearPair> known_pairs(const World& world) {
  std::vector<NearPair> pairs;
  for (const PairMemory& m : world.contact_memory())
    pairs.push_back({m.first, m.second, m.touching, m.crossed});
  return pairs;
}

void set_known_pairs(World& world, std::span<const NearPair> pairs) {
  ContactMemory memory;
  for (const NearPair& p : pairs) {
    PairMemory& m = memory.emplace_back();
    m.first = p.first;
    m.second = p.second;
    m.touching = p.touching;
    m.crossed = p.crossed;
  }
  world.set_contact_memory(std::move(memory));
}

}  // namespace kerf
