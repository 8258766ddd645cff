#pragma once

#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/world/motion.h"
#include "core/world/placement.h"

namespace kerf {

class World;

// Where a body is and how it moves.
struct BodyState {
  BodyId id;
  Placement placement;
  Motion motion;
  friend bool operator==(const BodyState&, const BodyState&) = default;
};

// Two bodies that are near each other, or a body and the ground.
struct NearPair {
  BodyId first, second;   // first < second; the second is not valid for the ground
  bool touching = false;  // see PairMemory
  uint32_t crossed = 0;
  friend bool operator==(const NearPair&, const NearPair&) = default;
};

// The states of the bodies of a world that move or have moved. O(bodies).
std::vector<BodyState> moved_bodies(const World& world);

// The contact memory of pairs of bodies, without the details of their contacts (see World::contact_memory),
// and the reverse: nothing else is known of them then. `pairs` are sorted by their bodies. O(pairs).
std::vector<NearPair> known_pairs(const World& world);
void set_known_pairs(World& world, std::span<const NearPair> pairs);

}  // namespace kerf
