#pragma once

#include <map>
#include <vector>

#include "core/base/tick.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// The bodies of a match whose colliders are older than their faces, and when these are made anew.
//
// Making the collider of a vehicle takes as long as all else in a tick. So the physics goes on with the one
// that it has: for a few ticks while a beam removes faces, and for one where a piece came off. Two large ones
// are not made in the same tick.
class StaleColliders {
 public:
  // Notes whose faces a change at the time `now` has changed. Bodies that came have no collider yet.
  void note(const Delta& change, Ticks now);

  // Takes out the bodies whose colliders are to be made in the tick `now`, ascending: of those that are due,
  // the small ones, and of the large ones that which has been due for the longest time.
  std::vector<BodyId> take_due(const World& world, Ticks now);

 private:
  std::map<BodyId, Ticks> due_;
};

}  // namespace kerf
