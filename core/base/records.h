#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kerf {

// Memory for large arrays that grow chunk by chunk. A chunk consists of whole pages from the system, is
// zero-initialised, is aligned to kHugePage bytes and takes no physical memory until it is written.
inline constexpr size_t kHugePage = size_t{2} << 20;

// Allocate and free a chunk. Precondition: `bytes` is a positive multiple of kHugePage, the same for both
// calls. allocate_chunk throws std::bad_alloc.
void* allocate_chunk(size_t bytes);
void free_chunk(void* chunk, size_t bytes);

// Requests huge pages for the chunk, which saves TLB misses. This is only a hint.
void advise_huge_pages(void* chunk, size_t bytes);

// An array of trivially copyable records with undo.
//
// It grows chunk by chunk, so that growing never moves a record once the array is larger than kSmall. Between
// begin_change() and end_change() it saves the before-image of each page before the page is written; the
// resulting Change swaps those pages with the present ones. Undo and redo therefore cost time and memory in
// proportion to the pages written, not to the array, and restore it to the bit.
template <typename T>
class Records {
  static_assert(std::is_trivially_copyable_v<T>);

  static constexpr uint32_t records_in(size_t bytes) {
    uint32_t count = 1;
    while (2 * count * sizeof(T) <= bytes) count *= 2;
    return count;
  }

 public:
  static constexpr uint32_t kShift = sizeof(T) >= 32 ? 16 : 19;
  static constexpr uint32_t kChunk = uint32_t{1} << kShift;
  static constexpr size_t kChunkBytes = (kChunk * sizeof(T) + kHugePage - 1) / kHugePage * kHugePage;
  // Up to this number of records are in one small allocation, which moves when it grows.
  static constexpr uint32_t kSmall = records_in(size_t{64} << 10);
  static constexpr uint32_t kPage = records_in(512);  // records saved together

  // The pages and the size of the array before a command; after exchange(), those after it.
  class Change {
   public:
    size_t bytes() const { return pages_.size() * (sizeof(Page) + sizeof(Page*)); }
    // Returns true if the command changed anything.
    bool any() const { return resized_ || !pages_.empty(); }
    // The size of the array in its other state.
    uint32_t size() const { return size_; }
    // Calls visit(first, records) for each page that may have changed, in its other state from index `first`
    // on.
    template <typename Visit>
    void for_each_page(Visit visit) const {
      for (const auto& page : pages_) visit(page->index * kPage, std::span<const T>(page->records));
    }

   private:
    friend class Records;
    struct Page {
      uint32_t index;
      T records[kPage];
    };
    uint32_t size_ = 0;
    bool resized_ = false;
    std::vector<std::unique_ptr<Page>> pages_;
  };

  Records() = default;
  ~Records() { free_memory(); }
  Records(Records&& other) noexcept { swap(other); }
  Records& operator=(Records&& other) noexcept {
    swap(other);
    return *this;
  }
  // Copies the records; the copy has no open change.
  Records(const Records& other) : huge_growth_(other.huge_growth_) {
    grow_to(other.size_);
    for (uint32_t i = 0; i < other.size_; i += kChunk) {
      const size_t count = std::min(other.size_ - i, kChunk);
      std::memcpy(static_cast<void*>(chunks_[i >> kShift]), other.chunks_[i >> kShift], count * sizeof(T));
    }
  }
  Records& operator=(const Records& other) {
    Records copy(other);
    swap(copy);
    return *this;
  }

  // Precondition of both: i < size().
  const T& operator[](uint32_t i) const {
    assert(i < size_);
    return at(i);
  }
  // Returns the record for writing; saves its page first if a change is open.
  T& edit(uint32_t i) {
    assert(i < size_);
    if (i < remembered_) save_page(i / kPage);
    return at(i);
  }
  uint32_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  // Record i is chunks()[i >> kShift][i & (kChunk - 1)]. Valid until the array grows.
  const T* const* chunks() const { return chunks_.data(); }

  // Grows the array to `size` records; new ones are zero. No-op for a smaller size.
  void grow_to(uint32_t size) {
    if (size <= size_) return;
    reserve(size);
    clear_used(size);
    size_ = size;
    used_ = std::max(used_, size);
  }

  void push_back(const T& record) {
    if (size_ == capacity()) reserve(size_ + 1);
    if (size_ < remembered_) save_page(size_ / kPage);
    at(size_++) = record;
    used_ = std::max(used_, size_);
  }

  void reserve(uint32_t size) {
    if (size <= capacity()) return;
    if (size <= kSmall) return make_small(std::min(kSmall, std::max(size, 2 * small_)));
    leave_small();
    reserved_ = size;
    while (capacity() < size) {
      const size_t wanted = std::min(size - capacity(), kChunk) * sizeof(T);
      chunks_.push_back(static_cast<T*>(allocate_chunk(kChunkBytes)));
      // Huge pages suit arrays that are filled at once. Adding records one by one would wait for a whole huge
      // page to be cleared, which pays only if they are then read at random.
      const bool whole = huge_growth_ && size * sizeof(T) >= kHugePage / 2;
      advise_huge_pages(chunks_.back(), whole ? kChunkBytes : wanted / kHugePage * kHugePage);
    }
  }

  // Requests huge pages for chunks that are added later, too.
  void grow_on_huge_pages() { huge_growth_ = true; }

  // Touches every reserved unused page, so that filling it later causes no page faults.
  void touch_reserved() {
    constexpr uint32_t kStride = std::max<uint32_t>(1, 4096 / sizeof(T));
    for (uint32_t i = size_; i < reserved_ && small_ == 0; i += kStride)
      std::memset(static_cast<void*>(&at(i)), 0, 1);
  }

  // Precondition: i is below the reserved capacity.
  void prefetch(uint32_t i) const {
    assert(i < capacity());
    __builtin_prefetch(&at(i));
  }

  // Opens a change: from now on each page is saved before it is first edited. Precondition: none is open.
  void begin_change() {
    assert(remembered_ == 0 && change_.pages_.empty());
    remembered_ = size_;
    change_.size_ = size_;
    saved_.resize((size_ / kPage + 64) / 64);
  }

  // Closes the open change and returns it.
  Change end_change() {
    remembered_ = 0;
    for (const auto& page : change_.pages_) saved_[page->index / 64] = 0;
    change_.resized_ = size_ != change_.size_;
    return std::exchange(change_, Change());
  }

  // Undoes the change and turns it into its own redo; a second call redoes it. Preconditions: no change is
  // open, and the array is as the change left it, i.e. later changes were undone before.
  void exchange(Change& change) {
    assert(remembered_ == 0 && std::max(size_, change.size_) <= used_);
    for (const auto& page : change.pages_) {
      const uint32_t first = page->index * kPage;
      std::swap_ranges(page->records, page->records + std::min(kPage, used_ - first), &at(first));
    }
    std::swap(size_, change.size_);
  }

  // Undoes the change as an edit, which an open change records. Precondition: the array is as the change left
  // it or has grown since; it may be a copy, which lacks the records beyond the end.
  void restore(const Change& change) {
    reserve(change.size_);
    used_ = std::max(used_, change.size_);
    // Saves the records beyond the new end here, because growing again overwrites them without saving.
    const uint32_t end = std::min(size_, remembered_);
    for (uint32_t i = change.size_; i < end; i += kPage - i % kPage) save_page(i / kPage);
    for (const auto& page : change.pages_) {
      const uint32_t first = page->index * kPage, count = std::min(kPage, used_ - first);
      if (first < remembered_) save_page(page->index);
      std::copy(page->records, page->records + count, &at(first));
    }
    size_ = change.size_;
  }

  // Memory used or reserved, in bytes. The unused rest of the last chunk takes no memory and does not count.
  size_t bytes() const {
    return std::max({used_, reserved_, small_}) * sizeof(T) + chunks_.capacity() * sizeof(T*) +
           saved_.capacity() * sizeof(uint64_t);
  }

 private:
  // Pages divide chunks evenly, so that no page crosses a chunk boundary.
  T& at(uint32_t i) { return chunks_[i >> kShift][i & (kChunk - 1)]; }
  const T& at(uint32_t i) const { return chunks_[i >> kShift][i & (kChunk - 1)]; }

  uint32_t capacity() const {
    return small_ > 0 ? small_
                      : static_cast<uint32_t>(std::min<size_t>(chunks_.size() * size_t{kChunk}, ~0u));
  }

  void make_small(uint32_t capacity) {
    constexpr size_t kLine = 64;
    const size_t bytes = (capacity * sizeof(T) + kLine - 1) / kLine * kLine;
    void* memory = std::aligned_alloc(kLine, bytes);
    if (!memory) throw std::bad_alloc();
    std::memset(memory, 0, bytes);
    if (small_ > 0) {
      std::memcpy(memory, static_cast<const void*>(chunks_[0]), used_ * sizeof(T));
      std::free(chunks_[0]);
      chunks_.clear();
    }
    chunks_.push_back(static_cast<T*>(memory));
    small_ = capacity;
  }

  void leave_small() {
    if (small_ == 0) return;
    T* chunk = static_cast<T*>(allocate_chunk(kChunkBytes));
    std::memcpy(static_cast<void*>(chunk), static_cast<const void*>(chunks_[0]), used_ * sizeof(T));
    std::free(chunks_[0]);
    chunks_[0] = chunk;
    small_ = 0;
  }

  // Zeroes records that an undo removed and that growing to `size` restores.
  void clear_used(uint32_t size) {
    for (uint32_t i = size_; i < std::min(size, remembered_); i += kPage - i % kPage) save_page(i / kPage);
    for (uint32_t i = size_; i < std::min(size, used_); ++i)
      std::memset(static_cast<void*>(&at(i)), 0, sizeof(T));
  }

  void save_page(uint32_t index) {
    uint64_t& word = saved_[index / 64];
    const uint64_t bit = uint64_t{1} << index % 64;
    if ((word & bit) != 0) return;
    word |= bit;
    auto& page = *change_.pages_.emplace_back(std::make_unique<typename Change::Page>());
    page.index = index;
    const uint32_t first = index * kPage;
    std::memcpy(static_cast<void*>(page.records), &at(first), std::min(kPage, used_ - first) * sizeof(T));
  }

  void free_memory() {
    for (T* chunk : chunks_) {
      if (small_ > 0)
        std::free(chunk);
      else
        free_chunk(chunk, kChunkBytes);
    }
    chunks_.clear();
  }
  void swap(Records& other) noexcept {
    std::swap(chunks_, other.chunks_);
    std::swap(size_, other.size_);
    std::swap(used_, other.used_);
    std::swap(small_, other.small_);
    std::swap(reserved_, other.reserved_);
    std::swap(huge_growth_, other.huge_growth_);
    std::swap(remembered_, other.remembered_);
    std::swap(saved_, other.saved_);
    std::swap(change_, other.change_);
  }

  std::vector<T*> chunks_;
  uint32_t size_ = 0;
  uint32_t used_ = 0;  // maximum size so far: redo restores records beyond size_
  bool huge_growth_ = false;
  uint32_t reserved_ = 0;    // maximum reserved capacity
  uint32_t small_ = 0;       // capacity of the small allocation; 0 if chunks are used
  uint32_t remembered_ = 0;  // records below this are saved before they are edited; 0 if no change is open
  std::vector<uint64_t> saved_;  // one bit per page: saved since begin_change()
  Change change_;
};

// The state of a value before a command; after exchange(), the state after it. The general version keeps a
// copy and suits values that are cheap to copy and to compare. A class with a nested type `Change`, which has
// the same functions, uses that instead.
//
// Call order: begin, the edits of the command, end, and then any number of exchange and restore. Precondition
// of these two: the value is as the change left it, i.e. later changes were undone.
template <typename T>
class ChangeOf {
 public:
  // Starts recording edits of `value`.
  void begin(T& value) { other_ = value; }
  void end(T& value) { differs_ = !(other_ == value); }
  // Returns true if the command changed anything.
  bool any() const { return differs_; }
  // Swaps the state of `value` with the recorded one, exactly to the bit.
  void exchange(T& value) { std::swap(value, other_); }
  // Sets `value` to the recorded state, as an edit that another open change records.
  void restore(T& value) const { value = other_; }
  size_t bytes() const { return 0; }

 private:
  T other_{};
  bool differs_ = false;
};

template <typename T>
class ChangeOf<Records<T>> {
 public:
  void begin(Records<T>& records) { records.begin_change(); }
  void end(Records<T>& records) { change_ = records.end_change(); }
  bool any() const { return change_.any(); }
  void exchange(Records<T>& records) { records.exchange(change_); }
  void restore(Records<T>& records) const { records.restore(change_); }
  size_t bytes() const { return change_.bytes(); }
  const typename Records<T>::Change& records() const { return change_; }

 private:
  typename Records<T>::Change change_;
};

template <typename T>
requires requires { typename T::Change; }
class ChangeOf<T> : public T::Change {};

// The change of an owner that lists once which of its members a command may change:
//
//   template <typename Self>
//   static auto parts(Self& self) { return std::tie(self.links_, self.positions_); }
//
// Self is the owner or the owner as const. Every function processes the members in that order.
template <typename Owner>
class ChangeOfParts {
 public:
  void begin(Owner& owner) {
    for_each_part(owner, changes_, [](auto& part, auto& change) { change.begin(part); });
  }
  void end(Owner& owner) {
    for_each_part(owner, changes_, [](auto& part, auto& change) { change.end(part); });
  }
  bool any() const {
    return std::apply([](const auto&... change) { return (change.any() || ...); }, changes_);
  }
  void exchange(Owner& owner) {
    for_each_part(owner, changes_, [](auto& part, auto& change) { change.exchange(part); });
  }
  void restore(Owner& owner) const {
    for_each_part(owner, changes_, [](auto& part, const auto& change) { change.restore(part); });
  }
  size_t bytes() const {
    return std::apply([](const auto&... change) { return (change.bytes() + ...); }, changes_);
  }

  // The change of the only member of this type, or of the member with this index.
  template <typename Part>
  const ChangeOf<Part>& part() const {
    return std::get<ChangeOf<Part>>(changes_);
  }
  template <size_t index>
  const auto& part_at() const {
    return std::get<index>(changes_);
  }

  static size_t bytes_of(const Owner& owner) {
    return std::apply([](const auto&... part) { return (bytes_of_part(part) + ...); }, Owner::parts(owner));
  }

 private:
  template <typename... Part>
  static std::tuple<ChangeOf<Part>...> changes_of(std::tuple<Part&...>);
  using Changes = decltype(changes_of(Owner::parts(std::declval<Owner&>())));

  template <typename SomeChanges, typename Visit>
  static void for_each_part(Owner& owner, SomeChanges& changes, Visit visit) {
    const auto parts = Owner::parts(owner);
    [&]<size_t... i>(std::index_sequence<i...>) { (visit(std::get<i>(parts), std::get<i>(changes)), ...); }
    (std::make_index_sequence<std::tuple_size_v<Changes>>());
  }

  template <typename Part>
  static size_t bytes_of_part(const Part& part) {
    if constexpr (requires { part.bytes(); }) {
      return part.bytes();
    } else {
      return 0;
    }
  }

  Changes changes_;
};

}  // namespace kerf
