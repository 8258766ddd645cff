#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace kerf {

// Disjoint sets over 0 .. count-1 with path halving (R. Tarjan, J. van Leeuwen: Worst-case analysis of set
// union algorithms, 1984). The representative of a set is its smallest member.
class UnionFind {
 public:
  explicit UnionFind(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  // Returns the representative of the set of x. Precondition: x < count. Amortised O(log count).
  uint32_t find(uint32_t x) {
    assert(x < parent_.size());
    while (parent_[x] != x) {
      parent_[x] = parent_[parent_[x]];
      x = parent_[x];
    }
    return x;
  }
  // Merges the sets of a and b. Returns true if they were different sets. Precondition: both are < count.
  bool unite(uint32_t a, uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    return true;
  }

 private:
  std::vector<uint32_t> parent_;
};

// A hash table from keys to item indices, by open addressing with linear probing. The caller stores the items
// and their keys; the table stores indices only. Items can be added but not removed. Results never depend on
// the order of entries in the table.
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

  // Returns the index of the item with this hash for which same(index) holds; kNone if there is none.
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

// A sparse array: unwritten items read as T(), and only written pages take memory. Growing moves no item.
template <typename T>
class PagedArray {
 public:
  static constexpr uint32_t kPage = 1024;  // items per page

  PagedArray() = default;
  PagedArray(PagedArray&&) noexcept = default;
  PagedArray& operator=(PagedArray&&) noexcept = default;
  PagedArray(const PagedArray& other) : pages_(other.pages_.size()) {
    for (size_t i = 0; i < pages_.size(); ++i) {
      if (other.pages_[i]) pages_[i] = std::make_unique<Page>(*other.pages_[i]);
    }
  }
  PagedArray& operator=(const PagedArray& other) { return *this = PagedArray(other); }

  T get(uint32_t i) const {
    const Page* page = page_of(i);
    return page ? (*page)[i % kPage] : T();
  }
  // Returns the item for writing; allocates its page.
  T& at(uint32_t i) {
    const size_t page = i / kPage;
    if (page >= pages_.size()) pages_.resize(page + 1);
    if (!pages_[page]) pages_[page] = std::make_unique<Page>();
    return (*pages_[page])[i % kPage];
  }

  void prefetch(uint32_t i) const {
    if (const Page* page = page_of(i)) __builtin_prefetch(&(*page)[i % kPage]);
  }

  // An exclusive upper bound of the indices written so far.
  uint32_t end() const { return static_cast<uint32_t>(pages_.size()) * kPage; }
  // Returns the items of the page of item i, beginning with index i - i % kPage; null if none was written.
  const T* page(uint32_t i) const {
    const Page* page = page_of(i);
    return page ? page->data() : nullptr;
  }

  void clear() { pages_.clear(); }
  size_t bytes() const {
    size_t bytes = pages_.capacity() * sizeof(pages_[0]);
    for (const auto& page : pages_) bytes += page ? sizeof(Page) : 0;
    return bytes;
  }

 private:
  using Page = std::array<T, kPage>;
  const Page* page_of(uint32_t i) const {
    return i / kPage < pages_.size() ? pages_[i / kPage].get() : nullptr;
  }

  std::vector<std::unique_ptr<Page>> pages_;
};

}  // namespace kerf
