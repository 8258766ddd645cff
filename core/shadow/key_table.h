#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace kerf {

// Finds the index of an item by the hash of its key: open addressing with linear probing. Items and their
// keys lie with the caller, who only adds; the answer never depends on the order within the table.
class KeyTable {
 public:
  static constexpr uint32_t kNone = 0xffffffffu;

  // The index of the item whose hash is `hash` and for which same(index) holds, or `next` after adding that.
  // hash_of(index) must give the hash of any item that was added. Expected constant time.
  template <typename Same, typename HashOf>
  uint32_t find_or_add(uint64_t hash, uint32_t next, const Same& same, const HashOf& hash_of) {
    if (2 * (count_ + 1) > slots_.size()) grow(hash_of);
    size_t at = hash & mask();
    for (; slots_[at] != kNone; at = (at + 1) & mask()) {
      if (same(slots_[at])) return slots_[at];
    }
    slots_[at] = next;
    ++count_;
    return next;
  }

  // Makes room for so many items in an empty table, so that adding them does not move it.
  void reserve(size_t items) { slots_.assign(std::bit_ceil(std::max<size_t>(16, 2 * (items + 1))), kNone); }

 private:
  size_t mask() const { return slots_.size() - 1; }

  template <typename HashOf>
  void grow(const HashOf& hash_of) {
    std::vector<uint32_t> old(slots_.empty() ? 16 : 2 * slots_.size(), kNone);
    old.swap(slots_);
    for (const uint32_t item : old) {
      if (item == kNone) continue;
      size_t at = hash_of(item) & mask();
      while (slots_[at] != kNone) at = (at + 1) & mask();
      slots_[at] = item;
    }
  }

  std::vector<uint32_t> slots_;  // a power of two of them, at most half of them taken
  size_t count_ = 0;
};

}  // namespace kerf
