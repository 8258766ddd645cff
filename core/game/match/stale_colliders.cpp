#include "core/game/match/stale_colliders.h"

#include <algorithm>

namespace kerf {

namespace {

constexpr Ticks kAfterRemoval = 15, kAfterDetaching = 1;
constexpr size_t kLarge = 2'000;  // faces

}  // namespace

void StaleColliders::note(const Delta& change, Ticks now) {
  if (change.anew) due_.clear();
  const auto make_due = [&](BodyId id, Ticks at) {
    Ticks& due = due_.try_emplace(id, at).first->second;
    due = std::min(due, at);
  };
  for (const BodyDelta& b : change.bodies) make_due(b.body, now + kAfterRemoval);
  for (const Detached& d : change.detached) make_due(d.from, now + kAfterDetaching);
  for (const Detached& d : change.detached) {
    if (!d.carries_on) continue;
    due_.erase(d.from);
    due_.erase(d.to);
  }
  for (const auto* list : {&change.came, &change.went}) {
    for (const BodyId id : *list) due_.erase(id);
  }
}

std::vector<BodyId> StaleColliders::take_due(const World& world, Ticks now) {
  std::vector<BodyId> taken;
  auto large = due_.end();
  for (auto at = due_.begin(); at != due_.end();) {
    if (at->second > now) {
      ++at;
    } else if (world.body(at->first).mesh.live_faces() < kLarge) {
      taken.push_back(at->first);
      at = due_.erase(at);
    } else {
      if (large == due_.end() || at->second < large->second) large = at;
      ++at;
    }
  }
  if (large == due_.end()) return taken;
  taken.push_back(large->first);
  due_.erase(large);
  std::sort(taken.begin(), taken.end());
  return taken;
}

}  // namespace kerf
