#include "core/physics/contact/impulse_memory.h"

#include <algorithm>

#include "core/physics/contact/chord_points.h"

namespace kerf {

void take_impulses(const PairMemory& memory, std::vector<Contact>& contacts) {
  for (Contact& c : contacts) {
    const auto at = std::ranges::lower_bound(memory.impulses, c.feature, {}, &ImpulseMemory::feature);
    if (at != memory.impulses.end() && at->feature == c.feature) c.impulse = at->impulse;
  }
}

namespace {

// Forgets the point at a rim that made a contact, if one did.
void forget_at_rim(uint64_t feature, PairMemory& memory) {
  if (feature >> 32 != 0) return;
  const bool of_second = (feature & kOnSecond) != 0;
  const auto point = static_cast<uint32_t>(of_second ? feature - kOnSecond : feature);
  if (!is_at_rim(point)) return;
  std::erase_if(of_second ? memory.points_of_second : memory.points_of_first,
                [&](const PointMemory& m) { return m.point == point; });
}

}  // namespace

void remember_impulses(const std::vector<Contact>& contacts, PairMemory& memory) {
  memory.impulses.clear();
  memory.touching = false;
  for (const Contact& c : contacts) {
    if (c.impulse[0] == 0) {
      forget_at_rim(c.feature, memory);
      continue;
    }
    memory.impulses.push_back({c.feature, c.impulse});
    memory.touching = true;
  }
  std::ranges::sort(memory.impulses, {}, &ImpulseMemory::feature);
}

}  // namespace kerf
