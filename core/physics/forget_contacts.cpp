#include "core/physics/forget_contacts.h"

#include <algorithm>
#include <vector>

#include "core/base/assert.h"
#include "core/world/body_state.h"

namespace kerf {

namespace {

// The bodies whose contacts a change ends.
std::vector<BodyId> changed_bodies(const World& world, const Delta& delta) {
  if (delta.anew || delta.environment) return world.ids();
  std::vector<BodyId> ids;
  for (const BodyDelta& b : delta.bodies) {
    if (!b.born.empty() || !b.gone.empty()) ids.push_back(b.body);
  }
  for (const auto* list :
       {&delta.came, &delta.went, &delta.moved, &delta.reweighed, &delta.hid_or_showed, &delta.pinned})
    ids.insert(ids.end(), list->begin(), list->end());
  for (const Detached& d : delta.detached) ids.insert(ids.end(), {d.from, d.to});
  return ids;
}

void wake(World& world, BodyId id) {
  if (world.contains(id)) world.body(id).motion.wake();
}

}  // namespace

void forget_details(World& world) {
  const std::vector<NearPair> pairs = known_pairs(world);
  set_known_pairs(world, pairs);
}

void forget_contacts(World& world, const Delta& delta) {
  forget_contacts(world, changed_bodies(world, delta));
}

void forget_contacts(World& world, std::vector<BodyId> changed) {
  KERF_ASSERT(std::all_of(changed.begin(), changed.end(), [](BodyId id) { return id.valid(); }));
  std::sort(changed.begin(), changed.end());
  const auto has_changed = [&](BodyId id) {
    return id.valid() && std::binary_search(changed.begin(), changed.end(), id);
  };
  for (const BodyId id : changed) wake(world, id);
  const auto ends = [&](const PairMemory& m) { return has_changed(m.first) || has_changed(m.second); };
  const ContactMemory& memory = world.contact_memory();
  if (std::none_of(memory.begin(), memory.end(), ends)) return;
  ContactMemory kept;
  for (const PairMemory& m : memory) {
    if (!ends(m)) {
      kept.push_back(m);
      continue;
    }
    wake(world, m.first);
    wake(world, m.second);
  }
  world.set_contact_memory(std::move(kept));
}

}  // namespace kerf
