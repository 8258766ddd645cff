#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kerf {

// A hash table that maps keys to item indices by open addressing with linear probing. The caller stores the
// items and their keys; the table stores indices only. Items can be added but not removed. Results never
// depend on the order of the entries within the table.
class KeyTable {
 public:
  static constexpr uint32_t kNone = 0xffffffffu;

  // Returns the index of the item with this hash for which same(index) holds; if there is none, adds `next`
  // and returns it. Precondition: hash_of(index) returns the hash of every item added before, and `next` is
  // not kNone. Expected constant time.
  template <typename Same, typename HashOf>
  uint32_t find_or_add(uint64_t hash, uint32_t next, const Same& same, const HashOf& hash_of) {
    assert(next != kNone);
    if (10 * (count_ + 1) > 7 * slots_.size()) grow(hash_of);
    size_t at = home(hash);
    for (; slots_[at] != kNone; at = after(at)) {
      if (same(slots_[at])) return slots_[at];
    }
    slots_[at] = next;
    ++count_;
    return next;
  }

  // The index of the item whose hash is `hash` and for which same(index) holds; kNone where there is none.
  template <typename Same>
  uint32_t find(uint64_t hash, const Same& same) const {
    if (slots_.empty()) return kNone;
    size_t at = home(hash);
    while (slots_[at] != kNone && !same(slots_[at])) at = after(at);
    return slots_[at];
  }

  // Allocates space for `items` items and a sixth more, so that adding them does not reallocate.
  // Precondition: the table is empty.
  void reserve(size_t items) {
    assert(count_ == 0);
    slots_.assign(kLeast + items / 3 * 5, kNone);
  }

  // Memory allocated, in bytes.
  size_t bytes() const { return slots_.capacity() * sizeof(uint32_t); }

 private:
  static constexpr size_t kLeast = 16;

  // The slot at which probing starts: the upper half of the hash, read as a fraction of the table's size.
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

  std::vector<uint32_t> slots_;  // fewer than 2^32 of them, at most 7 of 10 in use
  size_t count_ = 0;
};

}  // namespace kerf
