#include "ui/render/bodies/live_list.h"

#include <algorithm>

namespace kerf {

bool LiveList::set(uint32_t slot, bool live) {
  if (contains(slot) == live) return false;
  if (live) {
    place_[slot] = static_cast<uint32_t>(slots_.size());
    slots_.push_back(slot);
    changed_.mark(place_[slot]);
    return true;
  }
  const uint32_t place = place_[slot], last = slots_.back();
  slots_[place] = last;
  place_[last] = place;
  place_[slot] = kNone;
  slots_.pop_back();
  changed_.mark(place);
  return true;
}

std::vector<SlotRange> LiveList::take_changes(uint32_t gap) {
  const auto count = static_cast<uint32_t>(slots_.size());
  std::vector<SlotRange> ranges = changed_.take(gap, kNone);
  std::erase_if(ranges, [&](const SlotRange& r) { return r.begin >= count; });
  if (!ranges.empty()) ranges.back().end = std::min(ranges.back().end, count);
  return ranges;
}

}  // namespace kerf
