#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/tree/chunk_memory.h"

namespace kerf {

// An array of plain items that grows by chunks, so that growing never moves an item.
template <typename T>
class Pool {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  static constexpr uint32_t kShift = sizeof(T) >= 32 ? 16 : 19;
  static constexpr uint32_t kChunk = uint32_t{1} << kShift;
  static constexpr size_t kChunkBytes = (kChunk * sizeof(T) + kHugePage - 1) / kHugePage * kHugePage;

  Pool() = default;
  ~Pool() { clear(); }
  Pool(Pool&& other) noexcept { swap(other); }
  Pool& operator=(Pool&& other) noexcept {
    swap(other);
    return *this;
  }
  Pool(const Pool& other) {
    grow_to(other.size_);
    for (uint32_t i = 0; i < other.size_; i += kChunk) {
      const size_t count = other.size_ - i < kChunk ? other.size_ - i : kChunk;
      std::memcpy(chunks_[i >> kShift], other.chunks_[i >> kShift], count * sizeof(T));
    }
  }
  Pool& operator=(const Pool& other) {
    Pool copy(other);
    swap(copy);
    return *this;
  }

  T& operator[](uint32_t i) { return chunks_[i >> kShift][i & (kChunk - 1)]; }
  const T& operator[](uint32_t i) const { return chunks_[i >> kShift][i & (kChunk - 1)]; }
  uint32_t size() const { return size_; }

  // Where the chunks start: item i is chunks()[i >> kShift][i & (kChunk - 1)].
  T* const* chunks() const { return chunks_.data(); }

  // Items that were never there before are zero.
  void grow_to(uint32_t size) {
    if (size <= size_) return;
    reserve(size);
    size_ = size;
  }

  // Takes the chunks for so many items.
  void reserve(uint32_t size) {
    // Huge pages pay once a fair part of one is filled.
    constexpr uint32_t kHugeFrom = static_cast<uint32_t>(kHugePage / sizeof(T) / 2);
    while (chunks_.size() * size_t{kChunk} < size) {
      chunks_.push_back(static_cast<T*>(take_chunk(kChunkBytes)));
      if (size >= kHugeFrom) advise_huge_pages(chunks_.back(), kChunkBytes);
    }
  }

  size_t bytes() const { return size_ * sizeof(T) + chunks_.capacity() * sizeof(T*); }

 private:
  void clear() {
    for (T* chunk : chunks_) give_chunk(chunk, kChunkBytes);
    chunks_.clear();
    size_ = 0;
  }
  void swap(Pool& other) noexcept {
    std::swap(chunks_, other.chunks_);
    std::swap(size_, other.size_);
  }

  std::vector<T*> chunks_;
  uint32_t size_ = 0;
};

}  // namespace kerf
