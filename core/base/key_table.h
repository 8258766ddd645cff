#pragma once

#include <cstddef>
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
    if (10 * (count_ + 1) > 7 * slots_.size()) grow(hash_of);
    size_t at = home(hash);
    for (; slots_[at] != kNone; at = after(at)) {
      if (same(slots_[at])) return slots_[at];
    }
    slots_[at] = next;
    ++count_;
    return next;
  }

  // Makes room for so many items in an empty table, and a sixth more, so that adding them does not move it.
  void reserve(size_t items) { slots_.assign(kLeast + items / 3 * 5, kNone); }

  // Memory that it holds.
  size_t bytes() const { return slots_.capacity() * sizeof(uint32_t); }

 private:
  static constexpr size_t kLeast = 16;

  // Where the search begins: the hash, which is even in all its bits, as a fraction of the table.
  size_t home(uint64_t hash) const { return (hash >> 32) * slots_.size() >> 32; }
  size_t after(size_t at) const { return at + 1 == slots_.size() ? 0 : at + 1; }

  template <typename HashOf>
  void grow(const HashOf& hash_of) {
    std::vector<uint32_t> old(slots_.empty() ? kLeast : slots_.size() + slots_.size() / 2, kNone);
    old.swap(slots_);
    for (const uint32_t item : old) {
      if (item == kNone) continue;
      size_t at = home(hash_of(item));
      while (slots_[at] != kNone) at = after(at);
      slots_[at] = item;
    }
  }

  std::vector<uint32_t> slots_;  // fewer than 2^32, at most 7 of 10 taken
  size_t count_ = 0;
};

}  // namespace kerf
