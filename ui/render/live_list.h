#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ui/render/face_slots.h"

namespace kerf {

// Which of a chunk's slots have something to draw, without gaps and in no order: removing one puts the last
// in its place. What was removed costs nothing to draw, however much was cut, and a slot that came and went
// between two pictures leaves no trace.
class LiveList {
 public:
  explicit LiveList(uint32_t slots) : place_(slots, kNone) {}

  bool contains(uint32_t slot) const { return place_[slot] != kNone; }
  // Adds or takes away a slot; whether that changed anything.
  bool set(uint32_t slot, bool live);

  std::span<const uint32_t> slots() const { return slots_; }
  // The places in slots() that changed since the last call, within what there is of them.
  std::vector<SlotRange> take_changes(uint32_t gap);

  // Memory that it holds.
  size_t bytes() const { return (slots_.capacity() + place_.capacity()) * sizeof(uint32_t); }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;
  std::vector<uint32_t> slots_;
  std::vector<uint32_t> place_;  // by slot
  DirtySlots changed_;
};

}  // namespace kerf
