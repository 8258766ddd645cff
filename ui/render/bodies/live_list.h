#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ui/render/bodies/face_slots.h"

namespace kerf {

// The slots of a chunk that are to be drawn, without gaps and in unspecified order: the last one takes the
// place of a removed one. Removed faces therefore cost nothing to draw.
class LiveList {
 public:
  // Makes room for so many slots, at least as many as before.
  void make_room(uint32_t slots) { place_.resize(slots, kNone); }

  // Precondition of this and the next one: there is room for the slot.
  bool contains(uint32_t slot) const { return place_[slot] != kNone; }
  // Adds or removes a slot. Returns whether that changed anything. Constant time.
  bool set(uint32_t slot, bool live);

  std::span<const uint32_t> slots() const { return slots_; }
  // The ranges of slots() that changed since the last call; ranges separated by at most `gap` unchanged
  // places are joined.
  std::vector<SlotRange> take_changes(uint32_t gap);

  // Memory allocated, in bytes.
  size_t bytes() const { return (slots_.capacity() + place_.capacity()) * sizeof(uint32_t); }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;
  std::vector<uint32_t> slots_;
  std::vector<uint32_t> place_;  // by slot
  DirtySlots changed_;
};

}  // namespace kerf
